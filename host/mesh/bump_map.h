#pragma once

#include "image/texel_values.h"

namespace calotype {

/// Whether the channels of a texel differ by 5 % of the range at most on average, as in a map of
/// heights that was saved as a JPEG; in a normal map they differ by far more.
bool isGrey(const TexelImage& image);

/// The tangent-space normal map (+Y up, 2 c - 1) of the heights in one channel: central differences
/// that wrap around, so that a step of one per texel, times `steepness`, is a slope of 45 degrees.
TexelImage normalMapFromHeights(const TexelImage& heights, TexelChannel channel, double steepness);

/// A normal map whose slopes are `steepness` times those of `normals`.
TexelImage steepenedNormalMap(const TexelImage& normals, double steepness);

} // namespace calotype
