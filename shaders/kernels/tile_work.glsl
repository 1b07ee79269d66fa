// The tile of a subgroup: assigns its pixels to lanes, and parks its work between dispatches.
#ifndef CALOTYPE_KERNELS_TILE_WORK_GLSL
#define CALOTYPE_KERNELS_TILE_WORK_GLSL

#include "film/tiles.glsl"
#include "kernels/lanes.glsl"
#include "kernels/parked_tasks.glsl"
#include "kernels/pixel_task.glsl"
#include "shared/render_structs.h"

layout(push_constant) uniform Parameters { RenderParameters parameters; };
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingBlock, rgba32f) uniform image2D block;
layout(set = 0, binding = kBindingCounters) buffer CountersBlock { RenderCounters counters; };
layout(set = 0, binding = kBindingTiles) readonly buffer Tiles { uint tiles[]; };

struct TileWork {
    uvec2 corner;  ///< its first pixel
    uint nextItem; ///< the first pixel that no lane has taken yet, in the order of the tile
};

uvec2 pixelOf(TileWork work, PixelTask task) { return pixelInTile(work.corner, task.item); }

bool isInPicture(uvec2 pixel) { return all(lessThan(pixel, parameters.cropSize)); }

SampleId sampleIdOf(uvec2 pixel, PixelTask task) {
    return SampleId(parameters.cropOrigin + pixel, parameters.firstSample + uint(task.sum.w),
                    parameters.seed);
}

/// Sets the task's sum to the block's sum of its pixel. A task without a pixel in the picture gets
/// a sum that needs no more samples.
void loadPixel(TileWork work, inout PixelTask task) {
    uvec2 pixel = pixelOf(work, task);
    task.hasPixel = task.item < kTileSize * kTileSize;
    bool isReal = task.hasPixel && isInPicture(pixel);
    task.sum = isReal ? imageLoad(block, ivec2(pixel)) : vec4(parameters.sampleEnd);
}

/// A task that has finished its pixel stores it and takes the next one; a task without a path
/// starts one.
void takeUpWork(inout TileWork work, inout PixelTask task) {
    bool isDone = task.hasPixel && !task.hasPath && uint(task.sum.w) >= parameters.sampleEnd;
    uvec2 pixel = pixelOf(work, task);
    if (isDone && isInPicture(pixel))
        imageStore(block, ivec2(pixel), task.sum);
    uvec4 done = subgroupBallot(isDone);
    if (isDone) {
        task.item = work.nextItem + subgroupBallotExclusiveBitCount(done);
        loadPixel(work, task);
    }
    work.nextItem += subgroupBallotBitCount(done);
    if (task.hasPixel && !task.hasPath && uint(task.sum.w) < parameters.sampleEnd) {
        task.path = startPath(sampleIdOf(pixelOf(work, task), task), camera, parameters.imageSize);
        task.hasPath = true;
        task.hasRay = true;
    }
}

uint parkingPlace(uint whichTask) {
    return (gl_WorkGroupID.x * kTasksPerLane + whichTask) * gl_SubgroupSize +
           gl_SubgroupInvocationID;
}

/// Continues where the last dispatch parked the tile, or starts the tile from the beginning.
TileWork resumeTile(uint tile) {
    TileWork work = TileWork(cornerOfTile(tile, parameters.cropSize), 0u);
    uint parked = loadParkedTask(parkingPlace(0u)).nextItem;
    work.nextItem = parked == 0u ? kTasksPerLane * gl_SubgroupSize : parked;
    return work;
}

PixelTask resumeTask(TileWork work, uint whichTask) {
    ParkedTask parked = loadParkedTask(parkingPlace(whichTask));
    bool isNew = parked.nextItem == 0u;
    PixelTask task;
    task.item = isNew ? whichTask * gl_SubgroupSize + gl_SubgroupInvocationID : parked.item;
    loadPixel(work, task);
    task.hasPath = !isNew && parked.hasPath != 0u;
    task.path = unpark(parked, sampleIdOf(pixelOf(work, task), task));
    task.hasRay = task.hasPath;
    task.isOver = false;
    task.hit = Hit(0.0, kNone, false);
    return task;
}

void parkTask(TileWork work, uint whichTask, bool isUnfinished, PixelTask task) {
    uvec2 pixel = pixelOf(work, task);
    if (task.hasPixel && isInPicture(pixel))
        imageStore(block, ivec2(pixel), task.sum);
    storeParkedTask(parkingPlace(whichTask), park(task, isUnfinished ? work.nextItem : 0u));
}

/// Stores the lane's tasks, and adds up the totals of the subgroup. If no ray of a lane ended in
/// the whole dispatch, none would end in the next one either: the path is cut.
void parkTile(TileWork work, inout PixelTask current, inout PixelTask waiting,
              inout LaneTotals totals) {
    bool isCut = current.hasPath && totals.raysEnded == 0u;
    totals.pathsCut += isCut ? 1u : 0u;
    if (isCut || current.isOver)
        endPath(current, totals);
    if (waiting.isOver)
        endPath(waiting, totals);
    uint unfinished = lanesWhere(current.hasPixel) + lanesWhere(waiting.hasPixel);
    parkTask(work, 0u, unfinished > 0u, current);
    parkTask(work, 1u, unfinished > 0u, waiting);
    uint rays = subgroupAdd(totals.raysEnded);
    uint paths = subgroupAdd(totals.pathsEnded);
    uint lost = subgroupAdd(totals.pathsLost);
    uint cut = subgroupAdd(totals.pathsCut);
    if (subgroupElect()) {
        atomicAdd(counters.rays, rays);
        atomicAdd(counters.paths, paths);
        atomicAdd(counters.nonFiniteSamples, lost);
        atomicAdd(counters.cutPaths, cut);
        atomicAdd(counters.unfinishedPixels, unfinished);
    }
}

#endif
