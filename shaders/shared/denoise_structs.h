// What the statistical denoiser reads on a device, and its constants (docs/models.md, "The
// statistical denoiser").
#ifndef CALOTYPE_SHARED_DENOISE_STRUCTS_H
#define CALOTYPE_SHARED_DENOISE_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// A pixel is mixed with others of the square of 2 * radius + 1 pixels around it, with weights that
/// fall like a normal distribution of their distance and of the differences of their features.
CALOTYPE_CONSTANT uint kDenoiserRadius = 8;
CALOTYPE_CONSTANT float kDistanceDeviation = 4.0f; ///< pixels
CALOTYPE_CONSTANT float kAlbedoDeviation = 0.02f;
CALOTYPE_CONSTANT float kNormalDeviation = 0.1f;

#include "shared/declare_structs.h"
#include "shared/denoise_struct_table.h"

/// A pixel, as host/denoise/pixel_statistics.h says, in units of a power of two that keep all
/// squares within the range of a float. Six rows of 16 bytes.
struct DenoiserPixel {
    NoisyColor color;
    NoisyColor patchColor;
    PixelGuides guides;
};

CALOTYPE_END_SHARED

#endif
