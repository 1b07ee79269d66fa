#pragma once

#include "image/texel_values.h"

namespace calotype {

/// Whether the channels of a texel differ by at most 5 % of the range on average, as in a height
/// map that was saved as a JPEG; in a normal map they differ by far more.
bool isGrey(const TexelImage& image);

/// Whether an image can be a tangent-space normal map: its mean normal, 2 c - 1 of each channel,
/// has |x| and |y| below 0.1 and z above 0.55. Normal maps in use have means of about (0, 0, 0.67
/// to 0.99); photographs have a z of at most 0.5.
bool looksLikeNormals(const TexelImage& image);

/// The tangent-space normal map (+Y up, 2 c - 1) of the heights in one channel, from wrapped
/// central differences. A step of one per texel, times `steepness`, is a slope of 45 degrees.
TexelImage normalMapFromHeights(const TexelImage& heights, TexelChannel channel, double steepness);

/// A normal map with `steepness` times the slopes of `normals`.
TexelImage steepenedNormalMap(const TexelImage& normals, double steepness);

} // namespace calotype
