#version 460
// log(1 + x) and exp(x) - 1.
#extension GL_GOOGLE_include_directive : require

#include "core/exponential.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { float numbers[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { vec2 results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= numbers.length())
        return;
    results[i] = vec2(logOnePlus(numbers[i]), expMinusOne(numbers[i]));
}
