#pragma once

#include <cstdint>

#include "film/film_file.h"
#include "image/picture.h"

namespace calotype {

/// Sets the picture's metadata about the render, and its place in the whole picture. Facts that the
/// label does not have are left out. The time is no metadata, so that equal renders give equal
/// files.
void describe(Picture& picture, const FilmLabel& label, uint64_t samplesPerPixel);

} // namespace calotype
