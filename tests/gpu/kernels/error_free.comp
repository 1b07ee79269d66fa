#version 460
// What core/error_free.glsl finds of the numbers x, y, z and w.
#extension GL_GOOGLE_include_directive : require

#include "core/error_free.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { vec4 numbers[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { vec4 errors[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= numbers.length())
        return;
    vec4 n = numbers[i];
    precise float sum = n.x + n.y;
    precise float product = n.x * n.y;
    errors[i] = vec4(sumError(n.x, n.y, sum), productError(n.x, n.y, product),
                     differenceOfProducts(n.x, n.y, n.z, n.w), 0.0);
}
