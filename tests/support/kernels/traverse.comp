#version 460
// Rays through the BVH, by the loops that the rendering kernels trace theirs with.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "kernels/lane_rays.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestRay rays[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs { uvec4 hits[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    bool isActive = i < rays.length();
    TestRay test = rays[isActive ? i : 0u];
    Ray ray = Ray(test.origin, test.tMax, test.direction);
    IterationCount count = IterationCount(0u, ~0u);
    Hit hit = traceRay(ray, isActive, test.anyHit != 0u, test.primitive, count);
    if (isActive)
        hits[i] = uvec4(floatBitsToUint(hit.t), hit.primitive, count.passes, 0u);
}
