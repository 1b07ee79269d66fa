#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/film_options.h"
#include "engine/spare_file.h"
#include "film/film_file.h"
#include "gpu/device_info.h"
#include "settings/render_settings.h"

namespace calotype {

/// The film file of a render: reads it at the start, and writes checkpoints.
class FilmKeeper {
public:
    /// Called with a complete sentence.
    using OnWarning = std::function<void(const std::string&)>;

    /// Reads the film to continue, if there is one: that of `resume`, or `film` if it exists and is
    /// not to be overwritten. Throws SceneError if it is damaged or does not fit the label, or has
    /// less than `detail`. `spareFolders` is where the film is kept if its own folder has no room.
    FilmKeeper(const FilmOptions& options, FilmLabel label, const Crop& crop, ReplicaDetail detail,
               std::vector<std::filesystem::path> spareFolders, OnWarning onWarning);

    /// Whether a film is written at all.
    bool isWanted() const { return options_.keepsFilm(); }
    const std::string& path() const { return options_.path(); }
    const FilmLabel& label() const { return label_; }

    /// The number of blocks of the film to continue, before `begin`.
    uint64_t blocksToContinue() const { return continued_ ? continued_->film.blocks().count() : 0; }

    /// What denoisers use: of the film to continue, if it has it.
    const std::optional<DenoiserFeatures>& features() const { return features_; }
    /// To be called before `begin`, with ReplicaDetail::Color.
    void setFeatures(DenoiserFeatures features) {
        features_ = std::move(features);
        blocksInFile_.reset();
    }

    /// The film to continue, or an empty one of this size. A new film is written at once, so that
    /// there is a file whenever the program is killed. Throws SceneError if the film was made with
    /// lights of another strength, and OutputError.
    Film begin(const RenderSettings& settings, double maxRadiance, const DeviceInfo& device);

    /// Writes the film if the last time is long enough ago. If it cannot be written, warns, and the
    /// render continues.
    void checkpoint(const Film& film);

    /// Writes the film, unless its file holds these samples and features already. Throws
    /// OutputError, which says where the film is kept instead.
    void save(const Film& film);

private:
    using Clock = std::chrono::steady_clock;

    /// A film of the options, which must fit the label. `advice` ends the message if it does not.
    KeptFilm readOurs(const std::string& path, const char* advice) const;
    void readContinued();
    /// That of the film to continue, if it has more than is needed.
    ReplicaDetail detailOfContinued(const Film& continued) const;

    FilmOptions options_;
    FilmLabel label_;
    Crop crop_;
    ReplicaDetail detail_;
    SpareFile file_;
    OnWarning onWarning_;
    std::string lastWarning_;
    std::string device_;
    uint64_t blocksBefore_ = 0; ///< blocks of the film at the start
    /// None: the file at `path` is not this film's, or lacks its features.
    std::optional<uint64_t> blocksInFile_ = {};
    std::string continuedPath_;
    std::optional<KeptFilm> continued_;
    std::optional<DenoiserFeatures> features_;
    Clock::time_point lastSave_ = Clock::now();
};

} // namespace calotype
