// The pixels that the statistical denoiser reads: rows of a texel buffer, the parts of each pixel
// in the order of DenoiserPixel.
#ifndef CALOTYPE_BUFFERS_NOISY_PIXELS_GLSL
#define CALOTYPE_BUFFERS_NOISY_PIXELS_GLSL

#extension GL_EXT_samplerless_texture_functions : require

#include "shared/bindings.h"
#include "shared/denoise_structs.h"

layout(set = 0, binding = kBindingNoisyPixels) uniform utextureBuffer rowsOfNoisyPixels;

vec3 loadNoisyRow(uint pixel, uint row) {
    return uintBitsToFloat(texelFetch(rowsOfNoisyPixels, int(6u * pixel + row)).xyz);
}

NoisyColor loadColor(uint pixel) {
    return NoisyColor(loadNoisyRow(pixel, 0u), 0u, loadNoisyRow(pixel, 1u), 0u);
}

NoisyColor loadPatchColor(uint pixel) {
    return NoisyColor(loadNoisyRow(pixel, 2u), 0u, loadNoisyRow(pixel, 3u), 0u);
}

PixelGuides loadGuides(uint pixel) {
    return PixelGuides(loadNoisyRow(pixel, 4u), 0u, loadNoisyRow(pixel, 5u), 0u);
}

#endif
