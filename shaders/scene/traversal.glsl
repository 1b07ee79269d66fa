// Through the flattened BVH: the closest hit, or whether there is any.
//
// A node's box is passed where the ray's intervals between its three pairs of planes overlap. Each
// plane's parameter (b - o) * (1 / d) carries at most gamma_5 of relative error (difference,
// reciprocal of at most 2.5 ULP, product); widening the far side by twice that keeps every box that
// exact arithmetic would pass (Ize 2013, "Robust BVH Ray Traversal"). Components of the direction
// below 1e-18 are replaced before the reciprocal, so axis-parallel rays meet no NaN and no
// infinity; such a ray exactly in a box's face counts as inside on the lower side only, so of two
// boxes that share the face it enters one.
#ifndef CALOTYPE_SCENE_TRAVERSAL_GLSL
#define CALOTYPE_SCENE_TRAVERSAL_GLSL

#include "core/ray.glsl"
#include "core/select.glsl"
#include "scene/buffers.glsl"
#include "scene/features.glsl"
#include "shapes/quadric.glsl"
#include "shapes/triangle.glsl"
#include "shared/limits.h"

struct Hit {
    float t;
    uint primitive; ///< as kQuadricBit says; kNone for no hit
    uint material;  ///< index, with kTransparentBit
};

struct NodeRay {
    vec3 origin;
    vec3 inverse;
};

const float kFarWidening = 1.0 + 2.0 * GAMMA(5.0);

/// Parameter at which the ray enters the node's box, or kFar if it misses it before tMax.
float enterNode(NodeRay ray, BvhNode node, float tMax) {
    vec3 toLower = (node.lower - ray.origin) * ray.inverse;
    vec3 toUpper = (node.upper - ray.origin) * ray.inverse;
    float enter = greater(greatest(lesser(toLower, toUpper)), 0.0);
    float leave = lesser(least(greater(toLower, toUpper)) * kFarWidening, tMax);
    return enter <= leave ? enter : kFar;
}

/// The ray's crossing with one primitive; t is kFar where there is none.
Hit intersectPrimitive(uint primitive, Ray ray, ShearedRay sheared) {
    if (hasQuadrics && (!hasTriangles || (primitive & kQuadricBit) != 0u)) {
        Quadric quadric = loadQuadric(primitive & ~kQuadricBit);
        float t = intersectQuadric(quadric, ray.origin, ray.direction);
        return Hit(t, primitive, quadric.material);
    }
    Triangle triangle = loadTriangle(primitive);
    float t = intersectTriangle(sheared, triangle.v0, triangle.v1, triangle.v2);
    return Hit(t, primitive, triangle.material);
}

/// True where the hit may let light through.
bool isTransparent(Hit hit) { return hasAlpha && (hit.material & kTransparentBit) != 0u; }

// What is left to visit is kept in one word: a node's `first` with `count` in the bits that neither
// indices nor kQuadricBit use, so that taking it up again costs no fetch. kNone is the end.
const uint kCountShift = 28u;
const uint kCountMask = 7u << kCountShift;

uint contentsOf(BvhNode node) { return node.first | (node.count << kCountShift); }

/// Walks the tree: down to a leaf, nearer child first, then through the leaf's primitives, then on
/// with what was put aside last. `anyHit` ends at the first opaque hit; `skipped` is never hit.
///
/// `iterations` counts what llvmpipe has a limit on: the passes through loop bodies, and the last
/// look at a loop's condition, of the subgroup as a whole; hence the maxima after each loop. Both
/// sides of an `if` are paid for there, so choices are written as selections.
Hit traverse(Ray ray, bool anyHit, uint skipped, inout uint iterations) {
    NodeRay nodeRay = NodeRay(ray.origin, safeReciprocal(ray.direction));
    ShearedRay sheared = shearedRay(ray.origin, ray.direction);
    Hit hit = Hit(ray.tMax, kNone, 0u);
    uint stack[kMaxBvhDepth + 2u]; // the end, one a level, and one beyond that is read in vain
    stack[0] = kNone;
    uint stackSize = 1u;
    uint contents = contentsOf(loadNode(0u));
    do {
        while ((contents & kCountMask) == 0u) {
            BvhNode left = loadNode(contents);
            BvhNode right = loadNode(contents + 1u);
            float enterLeft = enterNode(nodeRay, left, hit.t);
            float enterRight = enterNode(nodeRay, right, hit.t);
            bool leftFirst = enterLeft <= enterRight;
            uint nearer = contentsOf(leftFirst ? left : right);
            uint farther = contentsOf(leftFirst ? right : left);
            stack[stackSize] = farther;
            stackSize += greater(enterLeft, enterRight) < kFar ? 1u : 0u;
            bool missed = lesser(enterLeft, enterRight) == kFar;
            stackSize -= missed ? 1u : 0u;
            uint aside = stack[stackSize];
            contents = missed ? aside : nearer;
            iterations++;
        }
        iterations = subgroupMax(iterations) + 1u;
        uint count = contents == kNone ? 0u : (contents & kCountMask) >> kCountShift;
        uint first = contents & ~kCountMask;
        for (uint i = 0u; i < count; ++i) {
            Hit crossing = intersectPrimitive(first + i, ray, sheared);
            bool nearest = crossing.t < hit.t && crossing.primitive != skipped;
            hit.t = nearest ? crossing.t : hit.t;
            hit.primitive = nearest ? crossing.primitive : hit.primitive;
            hit.material = nearest ? crossing.material : hit.material;
            iterations++;
        }
        iterations = subgroupMax(iterations) + 2u;
        bool isEnough = anyHit && hit.primitive != kNone && !isTransparent(hit);
        bool ended = contents == kNone || isEnough;
        stackSize -= ended ? 0u : 1u;
        contents = ended ? kNone : stack[stackSize];
    } while (contents != kNone);
    iterations = subgroupMax(iterations);
    return hit;
}

Hit intersectClosest(Ray ray, inout uint iterations) {
    return traverse(ray, false, kNone, iterations);
}

/// Some opaque primitive but `target` between the ray's ends, else the nearest that is transparent.
Hit intersectAny(Ray ray, uint target, inout uint iterations) {
    return traverse(ray, true, target, iterations);
}

#endif
