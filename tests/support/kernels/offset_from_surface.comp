#version 460
// Where rays that leave a surface start.
#extension GL_GOOGLE_include_directive : require

#include "core/ray.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { TestOffset points[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { vec4 origins[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= points.length())
        return;
    origins[i] = vec4(offsetFromSurface(points[i].position, points[i].error, points[i].ng), 0.0);
}
