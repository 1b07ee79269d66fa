#pragma once

#include <string>
#include <vector>

#include "film/film_file.h"

namespace calotype {

/// One film with the samples of all; there must be at least one. Throws SceneError if they do not
/// fit together: another scene, other settings, or samples that a film before it also holds.
KeptFilm mergeFilms(const std::vector<std::string>& paths);

} // namespace calotype
