#version 460
// The light that two random numbers choose.
#extension GL_GOOGLE_include_directive : require

#include "lights/light.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestLightQuery queries[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs { uint chosen[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < queries.length())
        chosen[i] = chooseLight(queries[i].lightCount, queries[i].u.zw);
}
