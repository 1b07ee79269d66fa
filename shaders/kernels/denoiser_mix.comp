#version 460
// Mixes each pixel with the pixels around it. What it takes of another, the other takes of it, so
// that the mean of the picture stays.
#extension GL_GOOGLE_include_directive : require

#include "kernels/denoiser_window.glsl"

layout(set = 0, binding = kBindingWeightSums) readonly buffer WeightSums { float sums[]; };
layout(set = 0, binding = kBindingCleanPixels) writeonly buffer CleanPixels { vec4 cleanPixels[]; };

void main() {
    uvec2 own = ownPixel();
    if (any(greaterThanEqual(own, parameters.windowSize)))
        return;
    DenoiserPixel pixel = loadPixel(indexOf(own));
    float ownSum = sums[indexOf(own)];
    uvec2 first = firstAround(own);
    uvec2 end = endAround(own);
    vec3 change = vec3(0.0);
    for (uint y = first.y; y < end.y; ++y)
        for (uint x = first.x; x < end.x; ++x) {
            uint other = indexOf(uvec2(x, y));
            NoisyColor color = loadColor(other);
            float weight = weightOf(pixel, other, color, vec2(x, y) - vec2(own));
            change += weight / max(ownSum, sums[other]) * (color.mean - pixel.color.mean);
        }
    cleanPixels[indexOf(own)] = vec4(pixel.color.mean + change, 0.0);
}
