#include "engine/film_label.h"

#include <utility>

#include "settings/settings_table.h"

namespace calotype {

FilmLabel labelOf(const Scene& scene, const RenderSettings& settings) {
    FilmLabel label;
    label.sceneHash = scene.hash;
    label.settings = sampleSettings(settings);
    label.settings["version"] = CALOTYPE_VERSION;
    return label;
}

KeptFilm readLabelledFilm(const std::filesystem::path& path) {
    KeptFilm kept = readFilm(path);
    kept.label.settings = normalized(std::move(kept.label.settings));
    return kept;
}

std::string nameWithDriver(const DeviceInfo& device) { return device.name + ", " + device.driver; }

} // namespace calotype
