#version 460
// Adds samples to the block in the storage image: each invocation owns one pixel and sums its
// samples in their order. rgb is the sum of the radiance, a the number of samples; so a dispatch
// goes on where the last one stopped, and the picture does not depend on how the work was cut up.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_basic : require

#include "film/finite.glsl"
#include "film/tiles.glsl"
#include "path/path.glsl"
#include "shared/render_structs.h"

// The loop of main itself, and one pass through each loop of transmittance, which llvmpipe makes
// even where no invocation takes that way.
const uint kIterationsOutsideTraversal = 5u;

layout(local_size_x = kTileSize * kTileSize) in;
layout(push_constant) uniform Parameters { RenderParameters parameters; };
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingBlock, rgba32f) uniform image2D block;
layout(set = 0, binding = kBindingCounters) buffer CountersBlock { RenderCounters counters; };

void main() {
    uint tile =
        (parameters.firstTile + gl_WorkGroupID.x) * parameters.tileStride % parameters.tileCount;
    uvec2 pixel = pixelOfInvocation(tile, gl_LocalInvocationIndex, parameters.cropSize);
    bool inPicture = all(lessThan(pixel, parameters.cropSize));
    vec4 sum = inPicture ? imageLoad(block, ivec2(pixel)) : vec4(0.0);
    uint sampleCount = uint(sum.w);
    SampleId id = SampleId(parameters.cropOrigin + pixel, 0u, parameters.seed);
    PathLimits limits = PathLimits(parameters.maxBounces, parameters.lightCount);
    PathCost cost = PathCost(0u, 0u, parameters.iterationsBeforeCut, false);
    uint nonFiniteSamples = 0u;
    uint cutPaths = 0u;
    uint pathsBefore = sampleCount;

    Path path;
    bool pathEnded = true;
    bool working = inPicture && sampleCount < parameters.sampleEnd;
    while (working) {
        if (pathEnded) {
            id.sampleIndex = parameters.firstSample + sampleCount;
            path = startPath(id, camera, parameters.imageSize);
            cost.cut = false;
        }
        pathEnded = !extendPath(path, limits, cost);
        cost.iterations = subgroupMax(cost.iterations) + kIterationsOutsideTraversal;
        // Also where the path seems to have ended: its last loops may have been broken off.
        bool outgrown = cost.cut || cost.iterations > parameters.iterationsBeforeCut;
        bool again = outgrown && sampleCount > pathsBefore; // with a dispatch's whole budget
        cutPaths += outgrown && !again ? 1u : 0u;
        pathEnded = pathEnded || outgrown;
        working = !again;
        if (pathEnded && working) {
            bool finite = isFinite(path.radiance) && isFinite(path.throughput);
            sum += vec4(finite ? path.radiance : vec3(0.0), 1.0);
            nonFiniteSamples += finite ? 0u : 1u;
            sampleCount++;
            working = sampleCount < parameters.sampleEnd &&
                      cost.iterations < parameters.iterationsBeforePause;
        }
    }

    if (inPicture)
        imageStore(block, ivec2(pixel), sum);
    uint unfinished = inPicture && sampleCount < parameters.sampleEnd ? 1u : 0u;
    uint rays = subgroupAdd(cost.rays);
    uint paths = subgroupAdd(sampleCount - pathsBefore);
    nonFiniteSamples = subgroupAdd(nonFiniteSamples);
    cutPaths = subgroupAdd(cutPaths);
    unfinished = subgroupAdd(unfinished);
    if (subgroupElect()) {
        atomicAdd(counters.rays, rays);
        atomicAdd(counters.paths, paths);
        atomicAdd(counters.nonFiniteSamples, nonFiniteSamples);
        atomicAdd(counters.cutPaths, cutPaths);
        atomicAdd(counters.unfinishedPixels, unfinished);
    }
}
