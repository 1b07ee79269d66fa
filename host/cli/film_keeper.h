#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cli/options.h"
#include "film/film_file.h"
#include "gpu/device_list.h"
#include "scene/scene.h"
#include "settings/bvh_builder.h"
#include "settings/render_settings.h"

namespace calotype {

/// What a film of these settings is labelled with. `filter` is that of all textures, if not theirs.
FilmLabel labelOf(const Scene& scene, const RenderSettings& settings,
                  std::optional<BvhBuilder> builder, std::optional<TextureFilter> filter);

/// "llvmpipe (LLVM 15.0.6, 256 bits), llvmpipe Mesa 22.3.6": as films name a device.
std::string nameWithDriver(const DeviceInfo& device);

/// The film of a render, in its file: what it held before, and its checkpoints.
class FilmKeeper {
public:
    /// Reads the film to go on with, if one is wanted. Throws SceneError where it is damaged or
    /// does not fit the label.
    FilmKeeper(const FilmOptions& options, FilmLabel label, const Crop& crop);

    /// Whether a film is to be kept at all.
    bool isWanted() const { return !path_.empty(); }
    const std::string& path() const { return path_; }
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

    const FilmOptions& options_;
    std::string path_; ///< empty: no film is kept
    FilmLabel label_;
    std::string device_;
    uint64_t blocksBefore_ = 0; ///< that the film began with
    std::optional<KeptFilm> resumed_;
    Clock::time_point lastSave_ = Clock::now();
};

} // namespace calotype
