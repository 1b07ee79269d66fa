#include "engine/film_keeper.h"

#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "engine/film_label.h"

namespace calotype {

FilmKeeper::FilmKeeper(const FilmOptions& options, FilmLabel label, const Crop& crop,
                       OnWarning onWarning)
    : options_(options), label_(std::move(label)), onWarning_(std::move(onWarning)) {
    if (options.resume.empty()) {
        if (isWanted() && isFilm(path()))
            onWarning_("'" + path() +
                       "' is a film already and will be replaced; --resume goes on with it");
        return;
    }
    resumed_ = readLabelledFilm(options.resume);
    requireSameOrigin(options.resume, *resumed_, label_, crop.width, crop.height,
                      resumed_->film.unit());
    label_.devices = resumed_->label.devices;
}

Film FilmKeeper::begin(const RenderSettings& settings, double maxRadiance,
                       const DeviceInfo& device) {
    const double unit = filmUnit(maxRadiance);
    if (resumed_)
        requireSameOrigin(options_.resume, *resumed_, label_, settings.crop.width,
                          settings.crop.height, unit);
    Film film = resumed_ ? std::move(resumed_->film)
                         : Film(settings.crop.width, settings.crop.height, unit);
    resumed_.reset();
    device_ = nameWithDriver(device);
    blocksBefore_ = film.blocks().count();
    if (isWanted() && !isFilm(path()))
        save(film);
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
        onWarning_(error.what());
    }
    lastSave_ = Clock::now();
}

void FilmKeeper::save(const Film& film) {
    if (film.blocks().count() > blocksBefore_)
        label_.devices.insert(device_);
    writeFilm(path(), label_, film);
}

} // namespace calotype
