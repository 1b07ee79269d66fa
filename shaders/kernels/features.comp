#version 460
// Finds what one ray of each pixel of a run of tiles shows. A tile's records are contiguous, row by
// row.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "film/tiles.glsl"
#include "kernels/lane_rays.glsl"
#include "kernels/record_words.glsl"
#include "path/features.glsl"

layout(local_size_x = kTileSize * kTileSize) in;
layout(push_constant) uniform Parameters { RecordParameters parameters; };
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingFeatures) writeonly buffer FeatureWords { uint words[]; };

void putRecord(uint index, FeatureRecord record) {
    uint place = index * kFeatureWords;
#define CALOTYPE_PUT(name, type, channels, help) PUT_WORDS(words, place, record.features.name)
    CALOTYPE_AVERAGED_LAYERS(CALOTYPE_PUT)
#undef CALOTYPE_PUT
    PUT_WORDS(words, place, record.primitive)
    PUT_WORDS(words, place, record.isCut)
}

void main() {
    uint tile = parameters.firstTile + gl_WorkGroupID.x;
    uvec2 pixel = pixelInTile(cornerOfTile(tile, parameters.cropSize), gl_LocalInvocationIndex);
    bool isInPicture = all(lessThan(pixel, parameters.cropSize));
    SampleId id = SampleId(parameters.cropOrigin + pixel, parameters.sampleIndex, parameters.seed);
    FeatureSearch search = startFeatures(id, camera, parameters.imageSize);
    search.goesOn = isInPicture;
    IterationCount count = IterationCount(0u, parameters.iterationsBeforeCut);
    bool isInBudget;
    do {
        Hit hit = traceRay(search.ray, search.goesOn, false, kNone, count);
        isInBudget = countIteration(count);
        if (search.goesOn) {
            extendFeatures(search, hit, camera, parameters.infiniteLight, isInBudget);
            search.record.isCut = isInBudget ? search.record.isCut : 1u;
        }
    } while (lanesWhere(search.goesOn) > 0u && isInBudget);
    if (!isInPicture)
        return;
    uvec2 inTile = pixel % kTileSize;
    uint index = (gl_WorkGroupID.x * kTileSize + inTile.y) * kTileSize + inTile.x;
    putRecord(index, search.record);
}
