#version 460
// Light paths by the steps of path/path.glsl, one an invocation, where diffuse surfaces transmit.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "image/kernels/boundary_lobe.glsl"
#include "kernels/lane_rays.glsl"
#include "path/path.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestPath tests[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs { vec4 radiances[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    bool isActive = i < tests.length();
    TestPath test = tests[isActive ? i : 0u];
    SceneLights lights = SceneLights(test.lightCount, test.infiniteLight, test.lightTreeDepth);
    PathLimits limits = PathLimits(test.maxBounces, kFar, lights);
    Path path =
        startPath(SampleId(test.pixel, test.sampleIndex, test.seed), test.camera, test.imageSize);
    IterationCount count = IterationCount(0u, ~0u);
    bool goesOn = isActive;
    while (lanesWhere(goesOn) > 0u) {
        Hit hit = traceRay(pathRay(path), goesOn, hasShadowRay(path), path.target, count);
        goesOn = goesOn && stepPath(path, hit, limits);
    }
    if (isActive)
        radiances[i] = vec4(path.radiance, 0.0);
}
