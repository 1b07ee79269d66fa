// The window of the picture that a dispatch of the statistical denoiser works on.
#ifndef CALOTYPE_KERNELS_DENOISER_WINDOW_GLSL
#define CALOTYPE_KERNELS_DENOISER_WINDOW_GLSL

#include "buffers/noisy_pixels.glsl"
#include "film/similarity.glsl"
#include "film/tiles.glsl"

layout(local_size_x = kTileSize * kTileSize) in;
layout(push_constant) uniform Parameters { DenoiserParameters parameters; };

/// The pixel of this invocation. The last tiles extend beyond the window.
uvec2 ownPixel() {
    uint tile = parameters.firstTile + gl_WorkGroupID.x;
    uvec2 inTile = uvec2(gl_LocalInvocationIndex % kTileSize, gl_LocalInvocationIndex / kTileSize);
    return cornerOfTile(tile, parameters.windowSize) + inTile;
}

uint indexOf(uvec2 pixel) { return pixel.y * parameters.windowSize.x + pixel.x; }

/// The pixels that count for `pixel` are from the first to before the second of these.
uvec2 firstAround(uvec2 pixel) { return pixel - min(pixel, uvec2(kDenoiserRadius)); }
uvec2 endAround(uvec2 pixel) { return min(pixel + kDenoiserRadius + 1u, parameters.windowSize); }

DenoiserPixel loadPixel(uint index) {
    return DenoiserPixel(loadColor(index), loadPatchColor(index), loadGuides(index));
}

/// The weight of another pixel of this index and colour, in [0, 1], the same for both. `offset` is
/// their distance in pixels.
float weightOf(DenoiserPixel pixel, uint other, NoisyColor color, vec2 offset) {
    if (!isWithinNoise(pixel.color, color, parameters.squaredBound) ||
        !isWithinNoise(pixel.patchColor, loadPatchColor(other), parameters.squaredBound))
        return 0.0;
    return similarityOf(pixel.guides, loadGuides(other), offset);
}

#endif
