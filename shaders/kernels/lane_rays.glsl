// The rays of a subgroup, one a lane, on their way through the tree together.
//
// A lane is about one of three things: its ray is among nodes, among primitives, or through. All
// lanes do the same at a time, so a loop goes on with one thing while enough of the lanes at work
// are about it, and the others wait (Aila and Laine 2009, "Understanding the Efficiency of Ray
// Traversal on GPUs"). Where quadrics are few, they are a fourth, in which no lane is left waiting.
#ifndef CALOTYPE_KERNELS_LANE_RAYS_GLSL
#define CALOTYPE_KERNELS_LANE_RAYS_GLSL

#include "accel/traversal.glsl"

layout(constant_id = kConstantNodeEighths) const uint kNodeEighths = 5u;
layout(constant_id = kConstantPrimitiveEighths) const uint kPrimitiveEighths = 3u;
layout(constant_id = kConstantRayEighths) const uint kRayEighths = 7u;

layout(constant_id = kConstantSharesStack) const bool sharesStack = false;
layout(local_size_x_id = kConstantSubgroupSize) in;

// What the lane's ray has put aside, in memory of its own or shared by the workgroup. Variables of
// the whole kernel, as GLSL copies arguments.
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

/// Passes through any loop of the kernel, which llvmpipe has a limit on.
struct IterationCount {
    uint passes;
    uint budget;
};

/// False where the dispatch is to end.
bool countIteration(inout IterationCount count) { return ++count.passes < count.budget; }

uint lanesWhere(bool condition) { return subgroupBallotBitCount(subgroupBallot(condition)); }

bool areEnough(bool condition, uint eighths, uint lanesAtWork) {
    return 8u * lanesWhere(condition) >= max(eighths * lanesAtWork, 1u);
}

/// Visits the lane's next node, if it is among nodes.
void visitNode(inout Traversal traversal) {
    bool visits = isAmongNodes(traversal);
    NodeGroup rest = traversal.nodes;
    uint index = takeNode(rest, traversal.boxRay.octant);
    putAside(stackSize, rest); // beyond the top where nothing is left of it
    uint size = stackSize + (hasNodes(rest) ? 1u : 0u);
    BvhNode node = loadNode(visits ? index : 0u);
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

/// Follows the rays until too many of the `atWork` lanes have theirs through, or the iterations
/// are used up: then false.
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

#endif
