#include "engine/film_keeper.h"

#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "engine/film_label.h"
#include "film/same_origin.h"

namespace calotype {
namespace {

constexpr const char* kAdvice = "; name another file with --film, or begin anew with --overwrite";

[[noreturn]] void failWith(const SceneError& error, const char* advice) {
    const std::string sentence = error.what();
    throw SceneError(error.where(), sentence.substr(error.where().size() + 2) + advice);
}

/// The film to resume must be in the one that exists where the result goes.
void requireNoneMissing(const std::string& path, const Film& film, const KeptFilm& resumed) {
    const BlockRanges missing = film.blocks().missingFrom(resumed.film.blocks());
    if (!missing.empty())
        throw SceneError(path,
                         "the film exists already, and lacks samples of the film to resume: " +
                             sampleText(missing) +
                             "; join the two with calotype merge, or write to another file "
                             "with --film");
}

} // namespace

FilmKeeper::FilmKeeper(const FilmOptions& options, FilmLabel label, const Crop& crop,
                       ReplicaDetail detail, std::vector<std::filesystem::path> spareFolders,
                       OnWarning onWarning)
    : options_(options), label_(std::move(label)), crop_(crop), detail_(detail),
      file_(options.path(), std::move(spareFolders)), onWarning_(std::move(onWarning)) {
    readContinued();
    if (continued_) {
        label_.devices = continued_->label.devices;
        features_ = std::move(continued_->features);
    }
    if (continued_ && continuedPath_ == path())
        blocksInFile_ = continued_->film.blocks().count();
}

KeptFilm FilmKeeper::readOurs(const std::string& path, const char* advice) const {
    try {
        KeptFilm kept = readLabelledFilm(path);
        requireSameOrigin(path, kept, label_, crop_.width, crop_.height, kept.film.unit(),
                          detailOfContinued(kept.film));
        return kept;
    } catch (const SceneError& error) {
        failWith(error, advice);
    }
}

ReplicaDetail FilmKeeper::detailOfContinued(const Film& continued) const {
    return detail_ == ReplicaDetail::Color ? detail_ : continued.detail();
}

void FilmKeeper::readContinued() {
    if (!options_.resume.empty()) {
        continuedPath_ = options_.resume;
        continued_ = readOurs(continuedPath_, "");
    }
    const bool isOther = !options_.film.empty() && options_.film != options_.resume;
    if (!isOther || options_.overwrites || !isFilm(options_.film))
        return;
    KeptFilm own = readOurs(options_.film, kAdvice);
    if (continued_)
        requireNoneMissing(options_.film, own.film, *continued_);
    continuedPath_ = options_.film;
    continued_ = std::move(own);
}

Film FilmKeeper::begin(const RenderSettings& settings, double maxRadiance,
                       const DeviceInfo& device) {
    const double unit = filmUnit(maxRadiance);
    if (continued_)
        requireSameOrigin(continuedPath_, *continued_, label_, settings.crop.width,
                          settings.crop.height, unit, detailOfContinued(continued_->film));
    Film film = continued_ ? std::move(continued_->film)
                           : Film(settings.crop.width, settings.crop.height, unit, detail_,
                                  settings.transport.hidesBackground);
    continued_.reset();
    device_ = nameWithDriver(device);
    blocksBefore_ = film.blocks().count();
    if (isWanted() && !isFilm(path())) {
        writeFilm(path(), label_, film, features_);
        blocksInFile_ = blocksBefore_;
    }
    lastSave_ = Clock::now();
    return film;
}

void FilmKeeper::checkpoint(const Film& film) {
    if (!isWanted() || secondsSince(lastSave_) <
                           options_.checkpointSeconds.value_or(FilmOptions::kCheckpointSeconds))
        return;
    try {
        save(film);
    } catch (const OutputError& error) { // a failed checkpoint does not end the render
        if (std::exchange(lastWarning_, error.what()) != error.what())
            onWarning_(error.what());
    }
    lastSave_ = Clock::now();
}

void FilmKeeper::save(const Film& film) {
    const uint64_t blocks = film.blocks().count();
    if (blocks == blocksInFile_ && isFilm(path()))
        return;
    if (blocks > blocksBefore_)
        label_.devices.insert(device_);
    file_.write("the film", [&](const std::filesystem::path& path) {
        writeFilm(path, label_, film, features_);
    });
    blocksInFile_ = blocks;
}

} // namespace calotype
