#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "film/film.h"

namespace calotype {

/// What is missing from a picture, a sentence each. `cutPixels` are those of the layers of first
/// hits that show a surface they should see through.
std::vector<std::string> lossWarnings(const FilmLosses& losses, uint64_t cutPixels = 0);

} // namespace calotype
