// The tile of a subgroup: handing its pixels to lanes, and putting its work down between
// dispatches.
#ifndef CALOTYPE_KERNELS_TILE_WORK_GLSL
#define CALOTYPE_KERNELS_TILE_WORK_GLSL

#include "film/tiles.glsl"
#include "path/pixel_task.glsl"

layout(push_constant) uniform Parameters { RenderParameters parameters; };
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingBlock, rgba32f) uniform image2D block;
layout(set = 0, binding = kBindingCounters) buffer CountersBlock { RenderCounters counters; };
layout(set = 0, binding = kBindingParkedPaths) buffer ParkedPaths { ParkedPath parkedPaths[]; };
layout(set = 0, binding = kBindingTiles) readonly buffer Tiles { uint tiles[]; };

struct TileWork {
    uvec2 corner;  ///< its first pixel
    uint nextItem; ///< the first pixel that no lane has taken, in the order of the tile
};

uvec2 pixelOf(TileWork work, PixelTask task) { return pixelInTile(work.corner, task.item); }

bool isInPicture(uvec2 pixel) { return all(lessThan(pixel, parameters.cropSize)); }

SampleId sampleIdOf(uvec2 pixel, PixelTask task) {
    return SampleId(parameters.cropOrigin + pixel, parameters.firstSample + uint(task.sum.w),
                    parameters.seed);
}

/// Gives the task's pixel, if it has one, as many samples as the block holds of it.
void loadPixel(TileWork work, inout PixelTask task) {
    uvec2 pixel = pixelOf(work, task);
    task.hasPixel = task.item < kTileSize * kTileSize;
    bool isReal = task.hasPixel && isInPicture(pixel);
    task.sum = isReal ? imageLoad(block, ivec2(pixel)) : vec4(parameters.sampleEnd);
}

/// Tasks that are done with their pixels store them and take the next ones; those without a path
/// start one.
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

/// Goes on where the last dispatch put the tile down, or begins it anew.
TileWork resumeTile(uint tile) {
    TileWork work = TileWork(cornerOfTile(tile, parameters.cropSize), 0u);
    uint parked = parkedPaths[parkingPlace(0u)].nextItem;
    work.nextItem = parked == 0u ? kTasksPerLane * gl_SubgroupSize : parked;
    return work;
}

PixelTask resumeTask(TileWork work, uint whichTask) {
    ParkedPath parked = parkedPaths[parkingPlace(whichTask)];
    bool isNew = parked.nextItem == 0u;
    PixelTask task;
    task.item = isNew ? whichTask * gl_SubgroupSize + gl_SubgroupInvocationID
                      : parked.item & ~(kTaskHasPath | kTaskIsShadowed);
    loadPixel(work, task);
    task.hasPath = !isNew && (parked.item & kTaskHasPath) != 0u;
    task.path = unpark(parked, sampleIdOf(pixelOf(work, task), task));
    task.hasRay = task.hasPath;
    task.isOver = false;
    task.hit = Hit(0.0, kNone, false);
    return task;
}

void putTaskDown(TileWork work, uint whichTask, bool isUnfinished, PixelTask task) {
    uvec2 pixel = pixelOf(work, task);
    if (task.hasPixel && isInPicture(pixel))
        imageStore(block, ivec2(pixel), task.sum);
    parkedPaths[parkingPlace(whichTask)] = park(task, isUnfinished ? work.nextItem : 0u);
}

/// Stores what the lane has, and adds up what the subgroup did. Where a lane got no ray through in
/// the whole dispatch, its own never will be, or those beside it: the path ends.
void putDown(TileWork work, inout PixelTask current, inout PixelTask waiting,
             inout LaneTotals totals) {
    bool isCut = current.hasPath && totals.raysEnded == 0u;
    totals.pathsCut += isCut ? 1u : 0u;
    if (isCut || current.isOver)
        endPath(current, totals);
    if (waiting.isOver)
        endPath(waiting, totals);
    uint unfinished = lanesWhere(current.hasPixel) + lanesWhere(waiting.hasPixel);
    putTaskDown(work, 0u, unfinished > 0u, current);
    putTaskDown(work, 1u, unfinished > 0u, waiting);
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
