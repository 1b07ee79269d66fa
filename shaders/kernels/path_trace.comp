#version 460
// Adds samples to the block in the storage image: rgb is the sum of a pixel's radiance, a the
// number of its samples, added in their order by the lane that owns the pixel. So a dispatch goes
// on where the last one stopped, and the picture does not depend on how the work was cut up.
//
// A workgroup is one subgroup. Its lanes do not wait for each other's paths: whose path has ended
// takes the next sample, or the tile's next pixel.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "kernels/lane_rays.glsl"
#include "kernels/tile_work.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

void main() {
    PathLimits limits = PathLimits(parameters.maxBounces, parameters.lightCount);
    TileWork work;
    Lane lane = resumeLane((parameters.firstTile + gl_WorkGroupID.x) * parameters.tileStride %
                               parameters.tileCount,
                           work);
    Traversal traversal = noTraversal();
    IterationCount count = IterationCount(0u, parameters.iterationBudget);
    bool isInBudget = true;
    do {
        if (lane.hasPath && !lane.hasRay && !isUnderWay(traversal))
            meetSurface(lane, traversal.hit, limits);
        takeUpWork(work, lane);
        uint atWork = lanesWhere(lane.hasPixel);
        do {
            if (lane.hasRay) {
                traversal = startTraversal(lane.path.ray, lane.path.isShadowed, lane.path.target);
                stackSize = 0u;
                lane.hasRay = false;
            }
            isInBudget = followRays(traversal, lane.path.ray, atWork, count);
            if (hasLights && lane.path.isShadowed && !isUnderWay(traversal) && lane.hasPath &&
                !traversal.hit.isTransparent)
                settleShadow(lane, traversal.hit);
            isInBudget = isInBudget && countIteration(count);
        } while (areEnough(lane.hasRay || isUnderWay(traversal), kPathEighths, atWork) &&
                 isInBudget);
        isInBudget = isInBudget && countIteration(count);
    } while (lanesWhere(lane.hasPixel) > 0u && isInBudget);
    putDown(work, lane);
}
