#version 460
// Sums the weights of the pixels around each pixel, its own weight of 1 included.
#extension GL_GOOGLE_include_directive : require

#include "kernels/denoiser_window.glsl"

layout(set = 0, binding = kBindingWeightSums) writeonly buffer WeightSums { float sums[]; };

void main() {
    uvec2 own = ownPixel();
    if (any(greaterThanEqual(own, parameters.windowSize)))
        return;
    DenoiserPixel pixel = loadPixel(indexOf(own));
    uvec2 first = firstAround(own);
    uvec2 end = endAround(own);
    float sum = 0.0;
    for (uint y = first.y; y < end.y; ++y)
        for (uint x = first.x; x < end.x; ++x) {
            uint other = indexOf(uvec2(x, y));
            sum += weightOf(pixel, other, loadColor(other), vec2(x, y) - vec2(own));
        }
    sums[indexOf(own)] = sum;
}
