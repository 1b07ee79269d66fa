#version 460
// Rays through the BVH.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "accel/traversal.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestRay rays[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs { uvec4 hits[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= rays.length())
        return;
    TestRay test = rays[i];
    uint iterations = 0u;
    Ray ray = Ray(test.origin, test.tMax, test.direction);
    Hit hit = traverse(ray, test.anyHit != 0u, test.primitive, iterations);
    hits[i] = uvec4(floatBitsToUint(hit.t), hit.primitive, iterations, 0u);
}
