#pragma once

#include <string>
#include <vector>

#include "film/film_file.h"

namespace calotype {

/// One film of the samples of all, at least one of them. Throws SceneError where they do not go
/// together: of another scene or other settings, or with samples that a film before it holds too.
KeptFilm mergeFilms(const std::vector<std::string>& paths);

} // namespace calotype
