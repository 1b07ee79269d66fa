// The state of one ray in the BVH, and the steps of its traversal. The loops that take these steps
// are in kernels/lane_rays.glsl.
#ifndef CALOTYPE_ACCEL_TRAVERSAL_GLSL
#define CALOTYPE_ACCEL_TRAVERSAL_GLSL

#include "accel/wide_node.glsl"
#include "buffers/packed_scene.glsl"
#include "config/features.glsl"
#include "core/ray.glsl"
#include "core/select.glsl"
#include "shapes/quadric.glsl"
#include "shapes/triangle.glsl"
#include "shared/limits.h"

struct Hit {
    float t;
    uint primitive;     ///< as kQuadricBit says; kNone for no hit
    bool isTransparent; ///< light may pass through the surface
};

bool isTransparent(uint material) { return (material & kTransparentBit) != 0u; }

// A ray's crossing with one primitive; t is kFar if there is none.

Hit crossTriangle(uint index, ShearedRay sheared) {
    Triangle triangle = loadTriangle(index);
    return Hit(intersectTriangle(sheared, triangle), index, isTransparent(triangle.material));
}

Hit crossQuadric(uint index, Ray ray) {
    Quadric quadric = loadQuadric(index);
    float t = intersectQuadric(quadric, ray.origin, ray.direction);
    return Hit(t, index | kQuadricBit, isTransparent(quadric.material));
}

Hit crossPrimitive(uint primitive, Ray ray, ShearedRay sheared) {
    if (hasQuadrics && (!hasTriangles || (primitive & kQuadricBit) != 0u))
        return crossQuadric(primitive & ~kQuadricBit, ray);
    return crossTriangle(primitive, sheared);
}

/// The traversal state of one ray. Its stack of nodes is in kernels/lane_rays.glsl.
struct Traversal {
    NodeRay boxRay;
    ShearedRay sheared;
    Hit hit;                   ///< the nearest so far
    NodeGroup nodes;           ///< to visit next
    PrimitiveGroup primitives; ///< to test now
    PrimitiveGroup postponed;  ///< to test after these; the ray visits no node while there are any
    PrimitiveGroup quadrics; ///< if the scene has few quadrics: all of those that are still to test
    uint skipped;            ///< the primitive that the ray ignores, or kNone
    bool anyHit;             ///< the ray ends at its first opaque hit
};

/// `anyHit`: the ray ends at the first opaque hit found. The ray ignores the primitive `skipped`,
/// or none if that is kNone.
Traversal startTraversal(Ray ray, bool anyHit, uint skipped) {
    NodeRay boxRay = nodeRay(ray.origin, ray.direction);
    return Traversal(boxRay, shearedRay(ray.origin, ray.direction), Hit(ray.tMax, kNone, false),
                     rootGroup(boxRay.octant), kNoPrimitives, kNoPrimitives, kNoPrimitives, skipped,
                     anyHit);
}

/// A ray that has nothing to visit.
Traversal noTraversal() {
    Traversal traversal = startTraversal(Ray(vec3(0.0), 0.0, vec3(1.0)), false, kNone);
    traversal.nodes = kNoNodes;
    return traversal;
}

bool waitsWithQuadrics(Traversal traversal) {
    return hasFewQuadrics && hasPrimitives(traversal.quadrics);
}

/// True if the ray's next step is to visit a node.
bool isAmongNodes(Traversal traversal) {
    return hasNodes(traversal.nodes) && !hasPrimitives(traversal.postponed) &&
           !waitsWithQuadrics(traversal);
}

bool isUnderWay(Traversal traversal) {
    return hasNodes(traversal.nodes) || hasPrimitives(traversal.primitives) ||
           waitsWithQuadrics(traversal);
}

NodeGroup nodesMet(BvhNode node, ChildrenMet met) { return NodeGroup(met.nodes | node.childBase); }

PrimitiveGroup primitivesMet(BvhNode node, ChildrenMet met) {
    return PrimitiveGroup(met.primitives, node.primitives, node.firstTriangle, node.firstQuadric);
}

/// Tests these primitives next, or, if the ray has others to test, after those.
void addPrimitives(inout Traversal traversal, PrimitiveGroup found) {
    if (hasFewQuadrics) {
        uint quadrics = quadricsOf(found);
        traversal.quadrics = only(quadrics, found);
        found = only(~quadrics, found);
    }
    bool isBusy = hasPrimitives(traversal.primitives);
    traversal.postponed = pick(isBusy, found, traversal.postponed);
    traversal.primitives = pick(isBusy, traversal.primitives, found);
}

/// Keeps the hit if it is the nearest so far.
void takeHit(inout Traversal traversal, bool isActive, Hit hit) {
    bool isNearest = isActive && hit.t < traversal.hit.t && hit.primitive != traversal.skipped;
    traversal.hit.t = isNearest ? hit.t : traversal.hit.t;
    traversal.hit.primitive = isNearest ? hit.primitive : traversal.hit.primitive;
    traversal.hit.isTransparent = isNearest ? hit.isTransparent : traversal.hit.isTransparent;
}

// Each function tests the next primitive of its kind, if there is one.

void testPrimitive(inout Traversal traversal, Ray ray) {
    bool isActive = hasPrimitives(traversal.primitives);
    uint primitive = takePrimitive(traversal.primitives);
    takeHit(traversal, isActive, crossPrimitive(isActive ? primitive : 0u, ray, traversal.sheared));
}

void testTriangle(inout Traversal traversal) {
    bool isActive = hasPrimitives(traversal.primitives);
    uint index = traversal.primitives.firstTriangle + takeOfOneKind(traversal.primitives);
    takeHit(traversal, isActive, crossTriangle(isActive ? index : 0u, traversal.sheared));
}

void testQuadric(inout Traversal traversal, Ray ray) {
    bool isActive = hasPrimitives(traversal.quadrics);
    uint index = traversal.quadrics.firstQuadric + takeOfOneKind(traversal.quadrics);
    takeHit(traversal, isActive, crossQuadric(isActive ? index : 0u, ray));
}

/// True if the ray ends here: further hits do not matter.
bool isSettled(Traversal traversal) {
    return traversal.anyHit && traversal.hit.primitive != kNone && !traversal.hit.isTransparent;
}

/// To call after a test: takes the postponed primitives next. A settled ray ends.
void takePostponed(inout Traversal traversal) {
    bool isDone = !hasPrimitives(traversal.primitives);
    traversal.primitives = pick(isDone, traversal.postponed, traversal.primitives);
    traversal.postponed.left = isDone ? 0u : traversal.postponed.left;
    if (isSettled(traversal)) {
        traversal.nodes = kNoNodes;
        traversal.primitives.left = 0u;
        traversal.postponed.left = 0u;
        traversal.quadrics.left = 0u;
    }
}

#endif
