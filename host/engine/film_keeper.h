#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "film/film_file.h"
#include "gpu/device_info.h"
#include "settings/render_settings.h"

namespace calotype {

/// Films to keep and go on with; empty paths are none.
struct FilmOptions {
    std::string film;
    std::string resume;
    std::optional<double> checkpointSeconds = {}; ///< none: the default

    static constexpr double kCheckpointSeconds = 60.0;

    bool keepsFilm() const { return !film.empty() || !resume.empty(); }

    /// Where the film is kept; empty for none.
    const std::string& path() const { return film.empty() ? resume : film; }
};

/// The film of a render, in its file: what it held before, and its checkpoints.
class FilmKeeper {
public:
    /// Told a complete sentence.
    using OnWarning = std::function<void(const std::string&)>;

    /// Reads the film to go on with, if one is wanted. Throws SceneError where it is damaged or
    /// does not fit the label.
    FilmKeeper(const FilmOptions& options, FilmLabel label, const Crop& crop, OnWarning onWarning);

    /// Whether a film is to be kept at all.
    bool isWanted() const { return options_.keepsFilm(); }
    const std::string& path() const { return options_.path(); }
    const FilmLabel& label() const { return label_; }

    /// The film to go on with, or an empty one of this size. Where there is no film yet, it is
    /// written, so that there is a film at whatever moment the program is killed. Throws SceneError
    /// where a film was of lights of another strength, and OutputError.
    Film begin(const RenderSettings& settings, double maxRadiance, const DeviceInfo& device);

    /// Keeps the film if the last time is long enough ago. A film that cannot be written is warned
    /// of, and the render goes on.
    void checkpoint(const Film& film);

    /// Keeps the film. Throws OutputError.
    void save(const Film& film);

private:
    using Clock = std::chrono::steady_clock;

    FilmOptions options_;
    FilmLabel label_;
    OnWarning onWarning_;
    std::string device_;
    uint64_t blocksBefore_ = 0; ///< that the film began with
    std::optional<KeptFilm> resumed_;
    Clock::time_point lastSave_ = Clock::now();
};

} // namespace calotype
