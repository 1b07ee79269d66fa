#include "engine/film_json.h"

#include "base/hexadecimal.h"
#include "engine/json_document.h"
#include "engine/statistics.h"
#include "film/error_estimate.h"
#include "settings/settings_table.h"
#include "shared/limits.h"

namespace calotype {
namespace {

using Json = nlohmann::ordered_json;

/// Pairs of the first sample and the one after the last.
Json rangesJson(const BlockRanges& ranges) {
    Json json = Json::array();
    for (const BlockRange& range : ranges.ranges())
        json.push_back(
            {range.begin * shared::kSamplesPerBlock, range.end * shared::kSamplesPerBlock});
    return json;
}

/// The values with the types that they have in all documents; a text if the value, or the setting
/// itself, is of another version.
Json settingsJson(const SettingTexts& texts) {
    Json json = Json::object();
    for (const auto& [name, text] : texts) {
        RenderSettings settings;
        const Setting* setting = findSetting(name);
        json[name] =
            setting && setting->read(text, settings) ? setting->value(settings) : Json(text);
    }
    return json;
}

} // namespace

Json filmJson(const KeptFilm& kept) {
    const Film& film = kept.film;
    Json json = newJsonDocument();
    json["scene_hash"] = hexadecimal(kept.label.sceneHash);
    json["devices"] = kept.label.devices;
    json["resolution"] = {film.width(), film.height()};
    json["spp"] = film.samplesPerPixel();
    json["ranges"] = rangesJson(film.blocks());
    json["missing"] = rangesJson(film.blocks().gaps());
    json["error"] = describeError(estimateError(film));
    json["can_denoise"] = film.detail() == ReplicaDetail::Color;
    json["settings"] = settingsJson(kept.label.settings);
    json["non_finite_samples"] = film.losses().nonFiniteSamples;
    json["cut_paths"] = film.losses().cutPaths;
    json["lost_blocks"] = film.losses().lostPixels();
    return json;
}

} // namespace calotype
