#pragma once

#include <functional>
#include <string>
#include <vector>

#include "film/film_file.h"

namespace calotype {

/// One film with the samples of all; there must be at least one. Throws SceneError if they do not
/// fit together: another scene, other settings, or samples that a film before it also holds.
/// `beforeEach` is called before each film but the first; it may throw to end the reading.
KeptFilm mergeFilms(const std::vector<std::string>& paths,
                    const std::function<void()>& beforeEach = {});

/// Throws SceneError if there is a film at `path` of the same scene and settings with samples that
/// `joined` lacks: it would be replaced by less.
void requireNoLess(const std::string& path, const KeptFilm& joined);

} // namespace calotype
