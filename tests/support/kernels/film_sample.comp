#version 460
// Positions in and around a pixel.
#extension GL_GOOGLE_include_directive : require

#include "film/film_filter.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { vec4 points[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs { vec2 positions[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= points.length())
        return;
    Camera camera;
    camera.filterIsBox = uint(points[i].z);
    positions[i] = sampleFilm(camera, points[i].xy);
}
