// The tile of a subgroup: handing its pixels to lanes, and putting its work down between
// dispatches.
#ifndef CALOTYPE_KERNELS_TILE_WORK_GLSL
#define CALOTYPE_KERNELS_TILE_WORK_GLSL

#include "film/tiles.glsl"
#include "path/lane.glsl"

layout(push_constant) uniform Parameters { RenderParameters parameters; };
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingBlock, rgba32f) uniform image2D block;
layout(set = 0, binding = kBindingCounters) buffer CountersBlock { RenderCounters counters; };
layout(set = 0, binding = kBindingParkedPaths) buffer ParkedPaths { ParkedPath parkedPaths[]; };

struct TileWork {
    uint tile;
    uvec2 corner;  ///< its first pixel
    uint nextItem; ///< the first pixel that no lane has taken, in the order of the tile
};

uvec2 pixelOf(TileWork work, Lane lane) { return pixelInTile(work.corner, lane.item); }

bool isInPicture(uvec2 pixel) { return all(lessThan(pixel, parameters.cropSize)); }

SampleId sampleIdOf(uvec2 pixel, Lane lane) {
    return SampleId(parameters.cropOrigin + pixel, parameters.firstSample + uint(lane.sum.w),
                    parameters.seed);
}

/// Gives the lane's pixel, if it has one, as many samples as the block holds of it.
void loadPixel(TileWork work, inout Lane lane) {
    uvec2 pixel = pixelOf(work, lane);
    lane.hasPixel = lane.item < kTileSize * kTileSize;
    bool isReal = lane.hasPixel && isInPicture(pixel);
    lane.sum = isReal ? imageLoad(block, ivec2(pixel)) : vec4(parameters.sampleEnd);
}

/// Lanes that are done with their pixels store them and take the next ones; those without a path
/// start one.
void takeUpWork(inout TileWork work, inout Lane lane) {
    bool isDone = lane.hasPixel && !lane.hasPath && uint(lane.sum.w) >= parameters.sampleEnd;
    uvec2 pixel = pixelOf(work, lane);
    if (isDone && isInPicture(pixel))
        imageStore(block, ivec2(pixel), lane.sum);
    uvec4 done = subgroupBallot(isDone);
    if (isDone) {
        lane.item = work.nextItem + subgroupBallotExclusiveBitCount(done);
        loadPixel(work, lane);
    }
    work.nextItem += subgroupBallotBitCount(done);
    if (lane.hasPixel && !lane.hasPath && uint(lane.sum.w) < parameters.sampleEnd) {
        lane.path = startPath(sampleIdOf(pixelOf(work, lane), lane), camera, parameters.imageSize);
        lane.hasPath = true;
        lane.hasRay = true;
    }
}

uint parkingPlace(TileWork work) { return work.tile * gl_SubgroupSize + gl_SubgroupInvocationID; }

/// Goes on where the last dispatch put the tile down, or begins it anew.
Lane resumeLane(uint tile, out TileWork work) {
    work.tile = tile;
    ParkedPath parked = parkedPaths[parkingPlace(work)];
    bool isNew = parked.nextItem == 0u;
    work.corner = cornerOfTile(tile, parameters.cropSize);
    work.nextItem = isNew ? gl_SubgroupSize : parked.nextItem;
    Lane lane;
    lane.item = isNew ? gl_SubgroupInvocationID : parked.item;
    loadPixel(work, lane);
    lane.hasPath = !isNew && (parked.state & kLaneHasPath) != 0u;
    lane.path = unpark(parked, sampleIdOf(pixelOf(work, lane), lane));
    lane.hasRay = lane.hasPath;
    lane.isOver = false;
    lane.raysEnded = 0u;
    lane.pathsEnded = 0u;
    lane.pathsLost = 0u;
    lane.pathsCut = 0u;
    return lane;
}

/// Stores what the lane has, and adds up what the subgroup did. A ray that has had the whole
/// dispatch to itself and is not through yet never will be: its path ends.
void putDown(TileWork work, inout Lane lane) {
    bool isCut = lane.hasPath && lane.raysEnded == 0u;
    lane.pathsCut += isCut ? 1u : 0u;
    if (isCut || lane.isOver)
        endPath(lane);
    uvec2 pixel = pixelOf(work, lane);
    if (lane.hasPixel && isInPicture(pixel))
        imageStore(block, ivec2(pixel), lane.sum);
    uint unfinished = lanesWhere(lane.hasPixel);
    parkedPaths[parkingPlace(work)] = park(lane, unfinished > 0u ? work.nextItem : 0u);
    uint rays = subgroupAdd(lane.raysEnded);
    uint paths = subgroupAdd(lane.pathsEnded);
    uint lost = subgroupAdd(lane.pathsLost);
    uint cut = subgroupAdd(lane.pathsCut);
    if (subgroupElect()) {
        atomicAdd(counters.rays, rays);
        atomicAdd(counters.paths, paths);
        atomicAdd(counters.nonFiniteSamples, lost);
        atomicAdd(counters.cutPaths, cut);
        atomicAdd(counters.unfinishedPixels, unfinished);
    }
}

#endif
