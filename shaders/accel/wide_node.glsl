// Intersects a ray with a node of the wide BVH: which children, in which order (Ylitie, Karras and
// Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs").
//
// A ray enters a box if its intervals between the three pairs of planes overlap. The ray crosses
// the plane that is k cells from the node's origin at
//     t = k (size / d) + (origin - o) / d,
// computed as k s + g with s = size * (1 / d) and g = (origin - o) * (1 / d). The reciprocal
// carries gamma_3, so s carries gamma_3 (size is a power of two) and g gamma_5 (difference,
// product); the product k s and the sum add one rounding each. With |k s| <= |t| + |g| the error is
// at most
//     gamma_7 (|t| + 2 |g|).
// So near planes are moved nearer by 2 gamma_7 |g|, and far planes farther by the same; far
// distances are also multiplied by 1 + 2 gamma_7, which covers the |t| of both (Ize 2013, "Robust
// BVH Ray Traversal"). Every box that the exact ray enters is entered.
//
// Components of the direction below 1e-18 are replaced before the reciprocal, so that axis-parallel
// rays give no NaN and no infinity.
#ifndef CALOTYPE_ACCEL_WIDE_NODE_GLSL
#define CALOTYPE_ACCEL_WIDE_NODE_GLSL

#include "config/features.glsl"
#include "core/rounding.glsl"
#include "core/select.glsl"
#include "shapes/slab.glsl"
#include "shared/scene_structs.h"

/// A ray prepared for tests against boxes.
struct NodeRay {
    vec3 origin;
    vec3 inverse;     ///< 1 / direction
    bvec3 isNegative; ///< of the components of the direction
    uint octant;      ///< bit 2, 1 or 0 is set if x, y or z of the direction is not negative
};

NodeRay nodeRay(vec3 origin, vec3 direction) {
    bvec3 isNegative = lessThan(direction, vec3(0.0));
    uint octant = (isNegative.x ? 0u : 4u) | (isNegative.y ? 0u : 2u) | (isNegative.z ? 0u : 1u);
    return NodeRay(origin, safeReciprocal(direction), isNegative, octant);
}

/// The children of a node that the ray enters.
struct ChildrenMet {
    uint nodes; ///< bit 24 + (child ^ octant) for each that is a node; the highest is visited first
    uint primitives; ///< for those that are leaves: their bits of BvhNode::primitives
};

vec4 bytesOf(uint word) {
    return vec4(word & 255u, word >> 8u & 255u, word >> 16u & 255u, word >> 24u);
}

/// Which of four children the ray enters, a bit each. The ray crosses near planes before far ones.
uint childrenMet(uvec3 near, uvec3 far, vec3 nearScale, vec3 nearStart, vec3 farScale,
                 vec3 farStart, float tMax) {
    vec4 enterX = bytesOf(near.x) * nearScale.x + nearStart.x;
    vec4 enterY = bytesOf(near.y) * nearScale.y + nearStart.y;
    vec4 enterZ = bytesOf(near.z) * nearScale.z + nearStart.z;
    vec4 leaveX = bytesOf(far.x) * farScale.x + farStart.x;
    vec4 leaveY = bytesOf(far.y) * farScale.y + farStart.y;
    vec4 leaveZ = bytesOf(far.z) * farScale.z + farStart.z;
    vec4 enter = greater(greater(enterX, enterY), greater(enterZ, vec4(0.0)));
    vec4 leave = lesser(lesser(leaveX, leaveY), lesser(leaveZ, vec4(tMax)));
    return (enter.x <= leave.x ? 1u : 0u) | (enter.y <= leave.y ? 2u : 0u) |
           (enter.z <= leave.z ? 4u : 0u) | (enter.w <= leave.w ? 8u : 0u);
}

/// Repeats each of the eight low bits three times.
uint thrice(uint bits) {
    bits = (bits | bits << 8u) & 0x0300F00Fu;
    bits = (bits | bits << 4u) & 0x030C30C3u;
    bits = (bits | bits << 2u) & 0x09249249u;
    return bits | bits << 1u | bits << 2u;
}

/// Moves bit i to the place i ^ octant.
uint inOrderOfVisit(uint bits, uint octant) {
    bits = (octant & 1u) != 0u ? (bits >> 1u & 0x55u) | (bits & 0x55u) << 1u : bits;
    bits = (octant & 2u) != 0u ? (bits >> 2u & 0x33u) | (bits & 0x33u) << 2u : bits;
    return (octant & 4u) != 0u ? bits >> 4u | (bits & 0x0Fu) << 4u : bits;
}

ChildrenMet meetNode(NodeRay ray, BvhNode node, float tMax) {
    const float kError = GAMMA(7.0);
    uint exponents = node.nodesAndExponents;
    vec3 size = uintBitsToFloat(
        uvec3(exponents & 255u, exponents >> 8u & 255u, exponents >> 16u & 255u) << 23u);
    vec3 scale = size * ray.inverse;
    vec3 start = (node.origin - ray.origin) * ray.inverse;
    vec3 pad = 2.0 * kError * abs(start);
    vec3 farScale = scale * (1.0 + 2.0 * kError);
    vec3 farStart = start * (1.0 + 2.0 * kError) + pad;
    vec3 nearStart = start - pad;
    uvec2 nearX = ray.isNegative.x ? node.upperX : node.lowerX;
    uvec2 nearY = ray.isNegative.y ? node.upperY : node.lowerY;
    uvec2 nearZ = ray.isNegative.z ? node.upperZ : node.lowerZ;
    uvec2 farX = ray.isNegative.x ? node.lowerX : node.upperX;
    uvec2 farY = ray.isNegative.y ? node.lowerY : node.upperY;
    uvec2 farZ = ray.isNegative.z ? node.lowerZ : node.upperZ;
    uint met = childrenMet(uvec3(nearX.x, nearY.x, nearZ.x), uvec3(farX.x, farY.x, farZ.x), scale,
                           nearStart, farScale, farStart, tMax) |
               childrenMet(uvec3(nearX.y, nearY.y, nearZ.y), uvec3(farX.y, farY.y, farZ.y), scale,
                           nearStart, farScale, farStart, tMax)
                   << 4u;
    uint nodes = met & node.nodesAndExponents >> 24u;
    return ChildrenMet(inOrderOfVisit(nodes, ray.octant) << 24u,
                       thrice(met) & node.primitives & 0x00FFFFFFu);
}

/// Children of one node that are nodes: the highest byte has those that are left to visit, as in
/// ChildrenMet; the rest is BvhNode::childBase. One word, because it goes on the stack.
struct NodeGroup {
    uint word;
};

const NodeGroup kNoNodes = NodeGroup(0u);

NodeGroup pick(bool first, NodeGroup a, NodeGroup b) { return NodeGroup(first ? a.word : b.word); }

/// The group of the root alone, which is at place 0.
NodeGroup rootGroup(uint octant) { return NodeGroup(1u << (24u + octant)); }

bool hasNodes(NodeGroup group) { return group.word > 0x00FFFFFFu; }

/// Removes the child to visit first from a group that is not empty, and returns its place.
uint takeNode(inout NodeGroup group, uint octant) {
    uint bit = uint(findMSB(group.word));
    group.word &= ~(1u << bit);
    return (group.word & 0x00FFFFFFu) + (bit - 24u ^ octant);
}

/// Primitives of a node's leaves.
struct PrimitiveGroup {
    uint left; ///< those still to test
    uint all;  ///< BvhNode::primitives
    uint firstTriangle;
    uint firstQuadric;
};

const PrimitiveGroup kNoPrimitives = PrimitiveGroup(0u, 0u, 0u, 0u);

bool hasPrimitives(PrimitiveGroup group) { return group.left != 0u; }

PrimitiveGroup pick(bool first, PrimitiveGroup a, PrimitiveGroup b) {
    return PrimitiveGroup(first ? a.left : b.left, first ? a.all : b.all,
                          first ? a.firstTriangle : b.firstTriangle,
                          first ? a.firstQuadric : b.firstQuadric);
}

/// The bits of those primitives that are quadrics.
uint quadricsOf(PrimitiveGroup group) { return thrice(group.all >> 24u); }

/// The group with these bits only.
PrimitiveGroup only(uint bits, PrimitiveGroup group) {
    return PrimitiveGroup(group.left & bits, group.all & bits, group.firstTriangle,
                          group.firstQuadric);
}

/// Removes one primitive from a group that has one kind only. Returns its rank among them.
uint takeOfOneKind(inout PrimitiveGroup group) {
    uint bit = uint(findLSB(group.left));
    group.left &= group.left - 1u;
    return uint(bitCount(group.all & ~(~0u << bit)));
}

/// Removes one primitive from a group that is not empty. Returns its name (kQuadricBit).
uint takePrimitive(inout PrimitiveGroup group) {
    if (!hasQuadrics)
        return group.firstTriangle + takeOfOneKind(group);
    if (!hasTriangles)
        return (group.firstQuadric + takeOfOneKind(group)) | kQuadricBit;
    uint quadrics = quadricsOf(group);
    bool isQuadric = (quadrics >> uint(findLSB(group.left)) & 1u) != 0u;
    PrimitiveGroup ofItsKind = only(isQuadric ? quadrics : ~quadrics, group);
    uint rank = takeOfOneKind(ofItsKind);
    group.left &= group.left - 1u;
    return isQuadric ? (group.firstQuadric + rank) | kQuadricBit : group.firstTriangle + rank;
}

#endif
