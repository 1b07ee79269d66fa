// Traces the rays of a subgroup, one per lane, through the BVH together.
//
// A lane is in one of three states: its ray visits nodes, tests primitives, or has ended. All lanes
// do the same work at a time. So a loop continues with one kind of work while enough of the working
// lanes need it, and the others wait (Aila and Laine 2009, "Understanding the Efficiency of Ray
// Traversal on GPUs"). If quadrics are few, testing them is a fourth state, and its loop runs until
// no lane is in it.
#ifndef CALOTYPE_KERNELS_LANE_RAYS_GLSL
#define CALOTYPE_KERNELS_LANE_RAYS_GLSL

#include "accel/traversal.glsl"
#include "config/settings.glsl"
#include "kernels/lanes.glsl"

// The stack of the lane's ray, in its own memory or in memory shared by the workgroup. These are
// variables of the whole kernel, because GLSL copies arguments.
const uint kStackPlaces = kMaxBvhDepth + 2u;
NodeGroup ownStack[sharesStack ? 1u : kStackPlaces];
shared NodeGroup sharedStack[sharesStack ? kStackPlaces * gl_WorkGroupSize.x : 1u];
uint stackSize = 0u;

uint sharedPlace(uint place) { return place * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

void putAside(uint place, NodeGroup group) {
    if (sharesStack)
        sharedStack[sharedPlace(place)] = group;
    else
        ownStack[place] = group;
}

NodeGroup groupAside(uint place) {
    if (sharesStack)
        return sharedStack[sharedPlace(place)];
    return ownStack[place];
}

/// Iterations of all loops of the kernel, which llvmpipe limits. The same in all lanes.
struct IterationCount {
    uint passes;
    uint budget;
};

bool isWithinBudget(IterationCount count) { return count.passes < count.budget; }

/// Counts one iteration. False if the budget is used up.
bool countIteration(inout IterationCount count) {
    count.passes++;
    return isWithinBudget(count);
}

/// Visits the next node of the lane's ray, if visiting a node is its next step.
void visitNode(inout Traversal traversal) {
    bool visits = isAmongNodes(traversal);
    NodeGroup rest = traversal.nodes;
    uint index = takeNode(rest, traversal.boxRay.octant);
    putAside(stackSize, rest); // above the top of the stack if `rest` is empty
    uint size = stackSize + (hasNodes(rest) ? 1u : 0u);
    BvhNode node = loadBvhNode(visits ? index : 0u);
    ChildrenMet met = meetNode(traversal.boxRay, node, traversal.hit.t);
    bool goesBack = met.nodes == 0u && size > 0u;
    size -= goesBack ? 1u : 0u;
    NodeGroup aside = groupAside(size);
    if (visits) {
        stackSize = size;
        traversal.nodes = pick(goesBack, aside, nodesMet(node, met));
        addPrimitives(traversal, primitivesMet(node, met));
    }
}

/// Traces the rays until too few of the `atWork` lanes have a ray that is not finished. False if
/// the budget is used up first.
bool followRays(inout Traversal traversal, Ray ray, uint atWork, inout IterationCount count) {
    bool isInBudget = true;
    do {
        do {
            visitNode(traversal);
            isInBudget = countIteration(count);
        } while (areEnough(isAmongNodes(traversal), kNodeEighths, atWork) && isInBudget);
        do {
            if (hasFewQuadrics)
                testTriangle(traversal);
            else
                testPrimitive(traversal, ray);
            takePostponed(traversal);
            isInBudget = countIteration(count);
        } while (areEnough(hasPrimitives(traversal.primitives), kPrimitiveEighths, atWork) &&
                 isInBudget);
        if (hasFewQuadrics) {
            do {
                testQuadric(traversal, ray);
                takePostponed(traversal);
                isInBudget = countIteration(count);
            } while (lanesWhere(waitsWithQuadrics(traversal)) > 0u && isInBudget);
        }
        isInBudget = countIteration(count);
    } while (areEnough(isUnderWay(traversal), kRayEighths, atWork) && isInBudget);
    return isInBudget;
}

/// Traces the ray of each active lane to its end, or until the budget is used up. `anyHit` and
/// `skipped` are those of startTraversal.
Hit traceRay(Ray ray, bool isActive, bool anyHit, uint skipped, inout IterationCount count) {
    Traversal traversal = noTraversal();
    if (isActive)
        traversal = startTraversal(ray, anyHit, skipped);
    stackSize = 0u;
    uint atWork = lanesWhere(isActive);
    bool isInBudget;
    do {
        isInBudget = followRays(traversal, ray, atWork, count) && countIteration(count);
    } while (lanesWhere(isUnderWay(traversal)) > 0u && isInBudget);
    return traversal.hit;
}

#endif
