#pragma once

#include <cstdint>

#include "film/film_file.h"
#include "image/picture.h"

namespace calotype {

/// Sets the picture's metadata, which say how it was made, and its place in the whole picture. What
/// the label does not tell is left out.
void describe(Picture& picture, const FilmLabel& label, uint64_t samplesPerPixel, double seconds);

} // namespace calotype
