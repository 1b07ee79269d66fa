#version 460
// Decoded sRGB values.
#extension GL_GOOGLE_include_directive : require

#include "core/srgb.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { float encoded[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { float linear[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= encoded.length())
        return;
    linear[i] = linearFromSrgb(encoded[i]);
}
