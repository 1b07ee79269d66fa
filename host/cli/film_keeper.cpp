#include "cli/film_keeper.h"

#include <cstdio>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/stopwatch.h"

namespace calotype {

FilmLabel labelOf(const Scene& scene, const RenderSettings& settings,
                  std::optional<BvhBuilder> builder, std::optional<TextureFilter> filter) {
    const auto text = [](auto number) { return std::to_string(number); };
    const auto onOff = [](bool isOn) { return isOn ? "on" : "off"; };
    const Crop& crop = settings.crop;
    const TransportSettings& transport = settings.transport;
    FilmLabel label;
    label.sceneHash = scene.hash;
    label.settings = {
        {"version", CALOTYPE_VERSION},
        {"size", text(settings.width) + "x" + text(settings.height)},
        {"crop",
         text(crop.x) + "," + text(crop.y) + "," + text(crop.width) + "," + text(crop.height)},
        {"seed", text(settings.seed)},
        {"sampler", nameOf(settings.sampler)},
        {"max_bounces", text(settings.maxBounces)},
        {"mis", onOff(transport.usesMis)},
        {"roulette", onOff(transport.usesRoulette)},
        {"clamp_indirect",
         transport.clampsIndirect() ? nlohmann::json(transport.indirectClamp).dump() : "off"},
        {"light_choice", nameOf(scene.lightChoice)},
        {"texture_filter", !filter                              ? "scene"
                           : *filter == TextureFilter::Bilinear ? "bilinear"
                                                                : "nearest"},
        {"bvh", nameOf(builder.value_or(BvhBuilder::Sah))},
    };
    return label;
}

std::string nameWithDriver(const DeviceInfo& device) { return device.name + ", " + device.driver; }

FilmKeeper::FilmKeeper(const FilmOptions& options, FilmLabel label, const Crop& crop)
    : options_(options), path_(options.film.empty() ? options.resume : options.film),
      label_(std::move(label)) {
    if (options.resume.empty()) {
        if (isWanted() && isFilm(path_))
            std::fprintf(stderr,
                         "calotype: warning: '%s' is a film already and will be replaced; --resume "
                         "goes on with it\n",
                         path_.c_str());
        return;
    }
    resumed_ = readFilm(options.resume);
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
    if (isWanted() && !isFilm(path_))
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
    } catch (const OutputError& error) { // the render is worth more than a checkpoint of it
        std::fprintf(stderr, "calotype: warning: %s\n", error.what());
    }
    lastSave_ = Clock::now();
}

void FilmKeeper::save(const Film& film) {
    if (film.blocks().count() > blocksBefore_)
        label_.devices.insert(device_);
    writeFilm(path_, label_, film);
}

} // namespace calotype
