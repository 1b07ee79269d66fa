#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/adaptive_film.h"

namespace calotype {

/// Distributes blocks of samples to pixels so that the picture's error (ErrorEstimate::relative) is
/// as small as possible: a pixel's share is proportional to the standard deviation of its samples
/// over sqrt(L^2 + (0.01 mean L)^2) (Neyman 1934), where L is its luminance. Both are taken from a
/// survey; variances are means over 7 x 7 pixels, because four replicas alone are too few.
///
/// Each pixel gets at least `least` blocks. Its share by noise is at most `most`, or its least if
/// that is more. If blocks are left over then, all pixels get the same number of them.
/// Returns the number of blocks of each pixel, row by row: `total` in all, up to rounding, or the
/// sum of the least if that is more.
std::vector<uint32_t> allocateBlocks(std::span<const SurveyPixel> survey, uint32_t width,
                                     std::span<const uint32_t> least, uint32_t most,
                                     uint64_t total);

} // namespace calotype
