#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "film/film.h"

namespace calotype {

/// What a film shows, and how it was rendered.
struct FilmLabel {
    uint64_t sceneHash = 0;
    /// The settings on which the samples depend, by name: size of the whole picture, place of the
    /// film in it, sampler, seed and so on.
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
/// bytes, in whatever order they were added. A film of R, G and B alone is of version 1 of the
/// format, one with more channels of version 2. Throws OutputError.
void writeFilm(const std::filesystem::path& path, const FilmLabel& label, const Film& film);

/// Throws SceneError with the path and the problem: a file that cannot be read, is not a film, has
/// an unknown version, is cut off, or whose checksum is not that of its contents.
KeptFilm readFilm(const std::filesystem::path& path);

/// Whether the file begins with the signature of films.
bool isFilm(const std::filesystem::path& path);

/// Throws SceneError at the path of `film` where it is of another scene, of other settings, of
/// another size in pixels, in another unit, or of other channels than what it is to join: the
/// message says in what they differ.
void requireSameOrigin(const std::filesystem::path& path, const KeptFilm& film,
                       const FilmLabel& label, uint32_t width, uint32_t height, double unit,
                       const std::vector<std::string>& channels = {"R", "G", "B"});

} // namespace calotype
