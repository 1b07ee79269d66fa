#version 460
// Textures at texture coordinates.
#extension GL_GOOGLE_include_directive : require

#include "scene/texture.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestTextureRead reads[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs { vec4 colors[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= reads.length())
        return;
    TestTextureRead read = reads[i];
    colors[i] = sampleTexture(read.index, read.uv, read.decode != 0u);
}
