#version 460
// Adds samples to the block in the storage image: rgb is the sum of a pixel's radiance, a the
// number of its samples (kHiddenSample). The lane that owns the pixel adds them in order. So the
// division of the work, into dispatches too, does not change the picture.
//
// A workgroup is one subgroup. Each lane works on two pixels, and takes the tile's next pixel when
// one is finished. While the ray of the current pixel's path is traced, the other pixel's path
// waits: either its ray is traced next, or it has reached a surface. When too few lanes have a ray
// left, the waiting paths take their steps.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "kernels/lane_rays.glsl"
#include "kernels/tile_work.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

/// True if its ray has been traced and the path must take a step, or if the path has ended.
bool isThrough(PixelTask task) { return task.hasPath && !task.hasRay; }

void main() {
    SceneLights lights =
        SceneLights(parameters.lightCount, parameters.infiniteLight, parameters.lightTreeDepth);
    PathLimits limits = PathLimits(parameters.maxBounces, parameters.indirectClamp, lights);
    TileWork work = resumeTile(tiles[parameters.firstTile + gl_WorkGroupID.x]);
    PixelTask current = resumeTask(work, 0u);
    PixelTask waiting = resumeTask(work, 1u);
    LaneTotals totals = LaneTotals(0u, 0u, 0u, 0u);
    Traversal traversal = noTraversal();
    IterationCount count = IterationCount(0u, parameters.iterationBudget);
    bool isInBudget = true;
    do {
        takeUpWork(work, waiting);
        uint atWork = lanesWhere(current.hasPixel || waiting.hasPixel);
        bool hasRay;
        do {
            if (!current.hasRay && !isUnderWay(traversal) && !isThrough(waiting))
                swapTasks(current, waiting);
            if (current.hasRay) {
                traversal = startTraversal(pathRay(current.path), hasShadowRay(current.path),
                                           current.path.target);
                stackSize = 0u;
                current.hasRay = false;
            }
            isInBudget = followRays(traversal, pathRay(current.path), atWork, count);
            current.hit = traversal.hit;
            if (hasShadowRay(current.path) && !isUnderWay(traversal) && current.hasPath &&
                !traversal.hit.isTransparent)
                settleShadow(current, limits, totals);
            isInBudget = isInBudget && countIteration(count);
            hasRay = current.hasRay || waiting.hasRay || isUnderWay(traversal);
        } while (areEnough(hasRay, kEventEighths, atWork) && isInBudget);
        if (isThrough(waiting)) // even without budget, so that each dispatch makes progress
            stepTask(waiting, limits, totals);
        count.passes += passesOfStep(lights);
        isInBudget = isInBudget && countIteration(count);
    } while (lanesWhere(current.hasPixel || waiting.hasPixel) > 0u && isInBudget);
    parkTile(work, current, waiting, totals);
}
