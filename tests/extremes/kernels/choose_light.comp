#version 460
// The light that two random numbers choose, and the place on it.
#extension GL_GOOGLE_include_directive : require

#include "lights/light.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestLightQuery queries[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs {
    TestLightChoice choices[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queries.length())
        return;
    LightChoice choice = chooseLight(queries[i].lightCount, queries[i].u.zw);
    choices[i] = TestLightChoice(choice.light, choice.u);
}
