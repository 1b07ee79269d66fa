#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "film/film.h"

namespace calotype {

/// Warnings about what is missing from a picture, one sentence each. `cutPixels` is the number of
/// pixels in first-hit layers that show a surface the ray should have passed through,
/// `cutFeatureRays` that of rays of the averaged layers.
std::vector<std::string> lossWarnings(const FilmLosses& losses, uint64_t cutPixels = 0,
                                      uint64_t cutFeatureRays = 0);

} // namespace calotype
