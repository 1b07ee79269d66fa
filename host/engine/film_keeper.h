#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "engine/film_options.h"
#include "film/film_file.h"
#include "gpu/device_info.h"
#include "settings/render_settings.h"

namespace calotype {

/// The film file of a render: reads it at the start, and writes checkpoints.
class FilmKeeper {
public:
    /// Called with a complete sentence.
    using OnWarning = std::function<void(const std::string&)>;

    /// Reads the film to resume, if there is one. Throws SceneError if it is damaged or does not
    /// fit the label.
    FilmKeeper(const FilmOptions& options, FilmLabel label, const Crop& crop, OnWarning onWarning);

    /// Whether a film is written at all.
    bool isWanted() const { return options_.keepsFilm(); }
    const std::string& path() const { return options_.path(); }
    const FilmLabel& label() const { return label_; }

    /// The film to resume, or an empty one of this size. A new film is written at once, so that
    /// there is a file whenever the program is killed. Throws SceneError if the film was made with
    /// lights of another strength, and OutputError.
    Film begin(const RenderSettings& settings, double maxRadiance, const DeviceInfo& device);

    /// Writes the film if the last time is long enough ago. If it cannot be written, warns, and the
    /// render continues.
    void checkpoint(const Film& film);

    /// Writes the film. Throws OutputError.
    void save(const Film& film);

private:
    using Clock = std::chrono::steady_clock;

    FilmOptions options_;
    FilmLabel label_;
    OnWarning onWarning_;
    std::string device_;
    uint64_t blocksBefore_ = 0; ///< blocks of the film at the start
    std::optional<KeptFilm> resumed_;
    Clock::time_point lastSave_ = Clock::now();
};

} // namespace calotype
