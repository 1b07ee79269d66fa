#version 460
// What each pixel of a run of tiles shows first. A tile's records lie together, row by row.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "film/tiles.glsl"
#include "path/first_hit.glsl"

layout(local_size_x = kTileSize * kTileSize) in;
layout(push_constant) uniform Parameters { FirstHitParameters parameters; };
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingFirstHits) writeonly buffer FirstHits {
    FirstHitRecord records[];
};

void main() {
    uint tile = parameters.firstTile + gl_WorkGroupID.x;
    uvec2 pixel = pixelInTile(cornerOfTile(tile, parameters.cropSize), gl_LocalInvocationIndex);
    if (any(greaterThanEqual(pixel, parameters.cropSize)))
        return;
    uvec2 inTile = pixel % kTileSize;
    uint index = (gl_WorkGroupID.x * kTileSize + inTile.y) * kTileSize + inTile.x;
    records[index] = firstHit(camera, parameters.cropOrigin + pixel, parameters.imageSize,
                              parameters.iterationsBeforeCut);
}
