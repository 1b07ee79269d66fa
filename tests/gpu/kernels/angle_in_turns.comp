#version 460
// Angles of points of the plane.
#extension GL_GOOGLE_include_directive : require

#include "core/trigonometry.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { vec2 points[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { float turns[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= points.length())
        return;
    turns[i] = angleInTurns(points[i].x, points[i].y);
}
