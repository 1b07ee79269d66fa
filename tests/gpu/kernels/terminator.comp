#version 460
// Where light leaves a smooth triangle.
#extension GL_GOOGLE_include_directive : require

#include "shapes/terminator.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { TestSmoothPoint points[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { vec4 offsets[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= points.length())
        return;
    TestSmoothPoint point = points[i];
    vec3 offset = terminatorOffset(point.triangle, point.normals, point.position,
                                   point.barycentrics, point.side);
    offsets[i] = vec4(offset, 0.0);
}
