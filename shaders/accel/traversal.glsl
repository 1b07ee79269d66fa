// A ray's state on its way through the BVH, and the steps that it takes there. The loops that take
// them are in kernels/lane_rays.glsl.
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
    bool isTransparent; ///< it may let light through
};

bool isTransparent(uint material) { return (material & kTransparentBit) != 0u; }

// A ray's crossing with one primitive; t is kFar where there is none.

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

/// A ray on its way through the tree. Its stack of nodes is kept by the loops.
struct Traversal {
    NodeRay boxRay;
    ShearedRay sheared;
    Hit hit;                   ///< the nearest so far
    NodeGroup nodes;           ///< to visit next
    PrimitiveGroup primitives; ///< to test next
    PrimitiveGroup postponed;  ///< to test after these, if the ray went on among nodes meanwhile
    PrimitiveGroup quadrics;   ///< where there are few of them: all that are left to test
    uint skipped;              ///< the primitive that is never hit, or kNone
    bool anyHit;               ///< any opaque hit will do
};

/// `anyHit`: the ray ends at the first opaque hit found. `skipped` is a primitive that it never
/// meets, or kNone.
Traversal startTraversal(Ray ray, bool anyHit, uint skipped) {
    NodeRay boxRay = nodeRay(ray.origin, ray.direction);
    return Traversal(boxRay, shearedRay(ray.origin, ray.direction), Hit(ray.tMax, kNone, false),
                     rootGroup(boxRay.octant), kNoPrimitives, kNoPrimitives, kNoPrimitives, skipped,
                     anyHit);
}

/// A ray that has nothing left to visit.
Traversal noTraversal() {
    Traversal traversal = startTraversal(Ray(vec3(0.0), 0.0, vec3(1.0)), false, kNone);
    traversal.nodes = kNoNodes;
    return traversal;
}

bool waitsWithQuadrics(Traversal traversal) {
    return hasFewQuadrics && hasPrimitives(traversal.quadrics);
}

/// Among nodes while no leaf has to be tested first.
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

/// To be tested next, or after those that are.
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

/// Keeps the nearest hit.
void takeHit(inout Traversal traversal, bool isActive, Hit hit) {
    bool isNearest = isActive && hit.t < traversal.hit.t && hit.primitive != traversal.skipped;
    traversal.hit.t = isNearest ? hit.t : traversal.hit.t;
    traversal.hit.primitive = isNearest ? hit.primitive : traversal.hit.primitive;
    traversal.hit.isTransparent = isNearest ? hit.isTransparent : traversal.hit.isTransparent;
}

// Each tests the next primitive of its kind, if there is one.

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

/// True where no further hit could matter.
bool isSettled(Traversal traversal) {
    return traversal.anyHit && traversal.hit.primitive != kNone && !traversal.hit.isTransparent;
}

/// After a test: what was postponed is next, and nothing where the ray is settled.
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
