#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/adaptive_film.h"

namespace calotype {

/// Deals out blocks of samples so that a picture's error (ErrorEstimate::relative) falls most: a
/// pixel's share is in proportion to the standard deviation of its samples over
/// sqrt(L^2 + (0.01 mean L)^2) (Neyman 1934), with L its luminance, as a survey of the picture
/// found them; variances are means over 7 x 7 pixels, since four replicas alone tell little.
///
/// `least` is what each pixel gets at least; noise brings none more than `most`, unless that is its
/// least. What is left over by then, of a survey that found little noise, goes to all alike.
/// Returns the number of each pixel, row by row, about `total` together, or the least if that is
/// more.
std::vector<uint32_t> allocateBlocks(std::span<const SurveyPixel> survey, uint32_t width,
                                     std::span<const uint32_t> least, uint32_t most,
                                     uint64_t total);

} // namespace calotype
