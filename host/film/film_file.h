#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "film/film.h"
#include "image/denoiser_features.h"

namespace calotype {

/// The setting of labels that is "on" for films with alpha, and no other.
inline constexpr const char* kAlphaSetting = "transparent";

/// The origin of a film: its scene and how it was rendered.
struct FilmLabel {
    uint64_t sceneHash = 0;
    /// The settings on which the samples depend, by name: size of the whole picture, place of the
    /// film in it, sampler, seed and so on.
    std::map<std::string, std::string> settings;
    std::set<std::string> devices; ///< that rendered it, with their drivers
    std::string camera;            ///< as JSON, for people; empty: unknown

    /// The value of a setting, or "none".
    std::string setting(const std::string& name) const;
};

struct KeptFilm {
    FilmLabel label;
    Film film;
    /// Of a film with the colours of replicas, so that it can be denoised without its scene.
    std::optional<DenoiserFeatures> features = {};
};

/// Writes a film to a file, atomically. The same samples by the same devices give the same bytes,
/// in whatever order they were added. A film with alpha has version 3 of the format, else one with
/// the colours of replicas version 2, any other version 1. The label's kAlphaSetting must fit the
/// film. Throws OutputError.
void writeFilm(const std::filesystem::path& path, const FilmLabel& label, const Film& film,
               const std::optional<DenoiserFeatures>& features = {});

/// Throws SceneError with the path and the problem: a file that cannot be read, is not a film, has
/// an unknown version, is cut off, or does not match its checksum.
KeptFilm readFilm(const std::filesystem::path& path);

/// Whether the file begins with the signature of films.
bool isFilm(const std::filesystem::path& path);

} // namespace calotype
