#version 460
#extension GL_GOOGLE_include_directive : require

#include "core/trigonometry.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { float turns[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { vec2 sinCos[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < turns.length())
        sinCos[i] = sinCosTwoPi(turns[i]);
}
