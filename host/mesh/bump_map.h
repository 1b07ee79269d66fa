#pragma once

#include "image/texel_values.h"

namespace calotype {

/// Whether the channels of a texel differ by at most 5 % of the range on average, as in a height
/// map that was saved as a JPEG; in a normal map they differ by far more.
bool isGrey(const TexelImage& image);

/// The tangent-space normal map (+Y up, 2 c - 1) of the heights in one channel, from wrapped
/// central differences. A step of one per texel, times `steepness`, is a slope of 45 degrees.
TexelImage normalMapFromHeights(const TexelImage& heights, TexelChannel channel, double steepness);

/// A normal map with `steepness` times the slopes of `normals`.
TexelImage steepenedNormalMap(const TexelImage& normals, double steepness);

} // namespace calotype
