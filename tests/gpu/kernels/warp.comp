#version 460
// Points of the unit square, warped.
#extension GL_GOOGLE_include_directive : require

#include "core/warp.glsl"
#include "gpu/kernels/warp_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { vec4 points[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { TestWarp warps[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= points.length())
        return;
    vec2 u = points[i].xy;
    vec3 direction = warpToCosineHemisphere(u);
    warps[i] = TestWarp(vec4(warpToDisk(u), warpToTriangle(u)), direction,
                        cosineHemispherePdf(direction.z));
}
