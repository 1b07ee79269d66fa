#version 460
// Lists the rays of a picture's paths: one ray of the given kind from each pixel's path.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "film/tiles.glsl"
#include "kernels/lane_rays.glsl"
#include "path/path.glsl"
#include "shared/ray_structs.h"

layout(local_size_x = kTileSize * kTileSize) in;
layout(push_constant) uniform Parameters { RayListParameters parameters; };
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingRays) writeonly buffer Rays { ListedRay rays[]; };

bool isWanted(Path path) {
    bool isShadow = parameters.isShadow != 0u;
    return hasShadowRay(path) == isShadow && (isShadow || path.bounce == parameters.bounces);
}

void main() {
    uint tile = parameters.firstGroup + gl_WorkGroupID.x;
    uvec2 pixel = pixelInTile(cornerOfTile(tile, parameters.imageSize), gl_LocalInvocationIndex);
    bool goesOn = all(lessThan(pixel, parameters.imageSize));
    Path path = startPath(SampleId(pixel, 0u, parameters.seed), camera, parameters.imageSize);
    SceneLights lights =
        SceneLights(parameters.lightCount, parameters.infiniteLight, parameters.lightTreeDepth);
    PathLimits limits = PathLimits(parameters.bounces + 1u, kFar, lights);
    IterationCount count = IterationCount(0u, parameters.iterationBudget);
    bool isInBudget = true;
    bool searches = goesOn && !isWanted(path);
    while (lanesWhere(searches) > 0u && isInBudget) {
        Hit hit = traceRay(pathRay(path), searches, hasShadowRay(path), path.target, count);
        count.passes += passesOfStep(lights);
        isInBudget = countIteration(count);
        if (searches)
            goesOn = isInBudget && stepPath(path, hit, limits);
        searches = goesOn && !isWanted(path);
    }
    bool isListed = goesOn && isWanted(path);
    rays[tile * kTileSize * kTileSize + gl_LocalInvocationIndex] =
        ListedRay(path.rayOrigin, isListed ? path.rayTMax : 0.0, path.rayDirection, path.target);
}
