#version 460
// Finds the first hit of each pixel of a run of tiles. A tile's records are contiguous, row by row.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "film/tiles.glsl"
#include "kernels/lane_rays.glsl"
#include "kernels/record_words.glsl"
#include "path/first_hit.glsl"

layout(local_size_x = kTileSize * kTileSize) in;
layout(push_constant) uniform Parameters { RecordParameters parameters; };
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingFirstHits) writeonly buffer FirstHits { uint words[]; };

void putRecord(uint index, FirstHitRecord record) {
    uint place = index * kFirstHitWords;
#define CALOTYPE_PUT(name, type, nothing, channels, help) PUT_WORDS(words, place, record.hit.name)
    CALOTYPE_FIRST_HIT_LAYERS(CALOTYPE_PUT)
#undef CALOTYPE_PUT
    PUT_WORDS(words, place, record.isCut)
}

void main() {
    uint tile = parameters.firstTile + gl_WorkGroupID.x;
    uvec2 pixel = pixelInTile(cornerOfTile(tile, parameters.cropSize), gl_LocalInvocationIndex);
    bool isInPicture = all(lessThan(pixel, parameters.cropSize));
    FirstHitSearch search =
        startFirstHit(camera, parameters.cropOrigin + pixel, parameters.imageSize);
    search.goesOn = isInPicture;
    IterationCount count = IterationCount(0u, parameters.iterationsBeforeCut);
    bool isInBudget;
    do {
        Hit hit = traceRay(search.ray, search.goesOn, false, kNone, count);
        isInBudget = countIteration(count);
        if (search.goesOn) {
            extendFirstHit(search, hit, camera, isInBudget);
            search.record.isCut = isInBudget ? search.record.isCut : 1u;
        }
    } while (lanesWhere(search.goesOn) > 0u && isInBudget);
    if (!isInPicture)
        return;
    uvec2 inTile = pixel % kTileSize;
    uint index = (gl_WorkGroupID.x * kTileSize + inTile.y) * kTileSize + inTile.x;
    putRecord(index, search.record);
}
