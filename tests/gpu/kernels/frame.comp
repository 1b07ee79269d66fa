#version 460
// Frames about unit vectors.
#extension GL_GOOGLE_include_directive : require

#include "core/frame.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { vec4 normals[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { mat3x4 frames[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < normals.length())
        frames[i] = mat3x4(worldFromLocal(normals[i].xyz));
}
