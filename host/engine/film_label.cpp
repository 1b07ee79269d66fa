#include "engine/film_label.h"

#include <cstdlib>
#include <numbers>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "settings/settings_table.h"

namespace calotype {

namespace {

using Json = nlohmann::ordered_json;

/// Twelve digits, so that angles that were given in degrees are the same again.
Json rounded(double number) {
    return std::strtod(shortNumber(number, 12).c_str(), nullptr) + 0.0; // which makes -0 be 0
}

Json rounded(const glm::dvec3& v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }

/// The camera with the keys of scene files.
std::string cameraText(const Camera& camera) {
    Json json;
    const bool isPerspective = camera.projection == Projection::Perspective;
    json["type"] = isPerspective ? "perspective" : "orthographic";
    json["position"] = rounded(camera.position);
    json["target"] = rounded(camera.position + camera.focusDistance * camera.forward);
    json["up"] = rounded(camera.up);
    if (isPerspective)
        json["fov"] = rounded(camera.verticalFov * (180.0 / std::numbers::pi));
    else
        json["height"] = rounded(camera.viewHeight);
    json["lens_radius"] = rounded(camera.lensRadius);
    return json.dump();
}

} // namespace

FilmLabel labelOf(const Scene& scene, const RenderSettings& settings) {
    FilmLabel label;
    label.sceneHash = scene.hash;
    label.settings = sampleSettings(settings);
    label.settings["version"] = CALOTYPE_VERSION;
    label.camera = cameraText(scene.camera);
    return label;
}

KeptFilm readLabelledFilm(const std::filesystem::path& path) {
    KeptFilm kept = readFilm(path);
    kept.label.settings = normalized(std::move(kept.label.settings));
    return kept;
}

std::string nameWithDriver(const DeviceInfo& device) { return device.name + ", " + device.driver; }

} // namespace calotype
