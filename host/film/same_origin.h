#pragma once

#include <cstdint>
#include <filesystem>

#include "film/film.h"
#include "film/film_file.h"

namespace calotype {

/// Throws SceneError with the path of `film` if the two films differ in scene, settings, size in
/// pixels, unit or detail, so that they cannot be joined; the message names the difference.
void requireSameOrigin(const std::filesystem::path& path, const KeptFilm& film,
                       const FilmLabel& label, uint32_t width, uint32_t height, double unit,
                       ReplicaDetail detail = ReplicaDetail::Luminance);

} // namespace calotype
