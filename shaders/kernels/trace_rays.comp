#version 460
// Finds the hits of a list of rays, with the same loops as the path tracing kernel.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "kernels/lane_rays.glsl"
#include "shared/ray_structs.h"

layout(local_size_x_id = kConstantSubgroupSize) in;
layout(push_constant) uniform Parameters { RayListParameters parameters; };
layout(set = 0, binding = kBindingRays) readonly buffer Rays { ListedRay rays[]; };
layout(set = 0, binding = kBindingListedHits) writeonly buffer ListedHits { ListedHit hits[]; };

void main() {
    uint group =
        (parameters.firstGroup + gl_WorkGroupID.x) * parameters.groupStride % parameters.groupCount;
    uint nextRay = group * kRaysPerGroup;
    uint end = min(nextRay + kRaysPerGroup, parameters.rayCount);
    bool anyHit = parameters.isShadow != 0u;
    uint index = kNone;
    Ray ray = Ray(vec3(0.0), 0.0, vec3(1.0));
    Traversal traversal = noTraversal();
    IterationCount count = IterationCount(0u, parameters.iterationBudget);
    bool hasRay = true;
    bool isInBudget = true;
    do {
        bool isThrough = !isUnderWay(traversal) && hasRay;
        if (isThrough && index != kNone)
            hits[index] = ListedHit(traversal.hit.t, traversal.hit.primitive, 0u, 0u);
        uvec4 through = subgroupBallot(isThrough);
        if (isThrough) {
            index = nextRay + subgroupBallotExclusiveBitCount(through);
            hasRay = index < end;
            ListedRay listed = rays[hasRay ? index : 0u];
            ray = Ray(listed.origin, listed.tMax, listed.direction);
            if (hasRay) {
                traversal = startTraversal(ray, anyHit, listed.target);
                stackSize = 0u;
            }
        }
        nextRay += subgroupBallotBitCount(through);
        isInBudget = followRays(traversal, ray, lanesWhere(hasRay), count) && countIteration(count);
    } while (lanesWhere(hasRay) > 0u && isInBudget);
}
