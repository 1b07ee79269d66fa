#pragma once

#include <optional>
#include <string>

namespace calotype {

/// Films to write and to resume; an empty path means none.
struct FilmOptions {
    std::string film;        ///< continued if it exists, else made
    std::string resume;      ///< must exist
    bool overwrites = false; ///< an existing `film` is not continued, but replaced
    std::optional<double> checkpointSeconds = {}; ///< none: kCheckpointSeconds

    static constexpr double kCheckpointSeconds = 60.0;

    bool keepsFilm() const { return !film.empty() || !resume.empty(); }

    /// The file that the film is written to; empty for none.
    const std::string& path() const { return film.empty() ? resume : film; }
};

} // namespace calotype
