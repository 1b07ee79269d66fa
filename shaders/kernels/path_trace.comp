#version 460
// Adds samples to the block in the storage image: rgb is the sum of a pixel's radiance, a the
// number of its samples, added in their order by the lane that owns the pixel. So a dispatch goes
// on where the last one stopped, and the picture does not depend on how the work was cut up.
//
// A workgroup is one subgroup. Each lane has two pixels, and takes the next one of the tile when
// one is done. While the ray of its current pixel's path is on its way through the tree, the other
// waits: with its own ray, to go next, or at a surface, until too few lanes have a ray left.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "kernels/lane_rays.glsl"
#include "kernels/tile_work.glsl"

layout(constant_id = kConstantEventEighths) const uint kEventEighths = 6u;

/// At the surface that its ray met, or its path over.
bool isThrough(PixelTask task) { return task.hasPath && !task.hasRay; }

void main() {
    PathLimits limits = PathLimits(parameters.maxBounces, parameters.lightCount,
                                   parameters.indirectClamp, parameters.backgroundLight);
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
                traversal =
                    startTraversal(current.path.ray, current.path.isShadowed, current.path.target);
                stackSize = 0u;
                current.hasRay = false;
            }
            isInBudget = followRays(traversal, current.path.ray, atWork, count);
            current.hit = traversal.hit;
            if (hasLights && current.path.isShadowed && !isUnderWay(traversal) && current.hasPath &&
                !traversal.hit.isTransparent)
                settleShadow(current, limits, totals);
            isInBudget = isInBudget && countIteration(count);
            hasRay = current.hasRay || waiting.hasRay || isUnderWay(traversal);
        } while (areEnough(hasRay, kEventEighths, atWork) && isInBudget);
        if (isThrough(waiting)) // whatever the budget: a dispatch gets on
            meetSurface(waiting, limits, totals);
        isInBudget = isInBudget && countIteration(count);
    } while (lanesWhere(current.hasPixel || waiting.hasPixel) > 0u && isInBudget);
    putDown(work, current, waiting, totals);
}
