#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "film/film.h"

namespace calotype {

/// What a film is of.
struct FilmLabel {
    uint64_t sceneHash = 0;
    /// What decides on the samples: size of the whole picture, place of the film in it, sampler,
    /// seed and so on, by name.
    std::map<std::string, std::string> settings;
    std::set<std::string> devices; ///< that rendered it, with their drivers

    /// The value of a setting, or "none".
    std::string setting(const std::string& name) const;
};

struct KeptFilm {
    FilmLabel label;
    Film film;
};

/// Keeps a film in a file, whole at every moment. The same samples by the same devices are the same
/// bytes, however they came together. Throws OutputError.
void writeFilm(const std::filesystem::path& path, const FilmLabel& label, const Film& film);

/// Throws SceneError with the path and what is wrong: a file that cannot be read, is no film, is of
/// another version, is cut off, or whose checksum is not that of its contents.
KeptFilm readFilm(const std::filesystem::path& path);

/// Whether the file begins as a film does.
bool isFilm(const std::filesystem::path& path);

/// Throws SceneError at the path of `film` where it is of another scene, of other settings, of
/// another size in pixels, or in another unit than what it is to join: the message says in what
/// they differ.
void requireSameOrigin(const std::filesystem::path& path, const KeptFilm& film,
                       const FilmLabel& label, uint32_t width, uint32_t height, double unit);

} // namespace calotype
