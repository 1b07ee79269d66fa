#pragma once

#include <cstdint>

#include "film/film_file.h"
#include "image/exr.h"

namespace calotype {

/// What an EXR file says of how its picture came about.
ExrMetadata exrMetadata(const FilmLabel& label, uint64_t samplesPerPixel, double seconds);

} // namespace calotype
