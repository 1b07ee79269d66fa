#include "study/json.h"

#include <cmath>

#include "engine/json_document.h"
#include "study/advice.h"

namespace calotype {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json();
}

Json describe(const CurvePoint& point) {
    return {{"spp", std::llround(point.samples)},
            {"seconds", point.seconds},
            {"true_error", orNull(point.error)},
            {"stated_error", orNull(point.stated)},
            {"stated_bound", orNull(point.bound)}};
}

Json describe(const Measurement& measurement) {
    Json json;
    json["name"] = measurement.variant.name;
    json["options"] = measurement.variant.options;
    json["loses_light"] = measurement.variant.losesLight;
    json["denoised"] = measurement.variant.isDenoised;
    json["trusted"] = measurement.isTrusted;
    json["seconds"] = {{"build", measurement.buildSeconds},
                       {"compile", measurement.compileSeconds}};
    json["pace"] = measurement.pace;
    json["brighter"] = orNull(measurement.brighter);
    json["brighter_standard_error"] = orNull(measurement.brighterError);
    json["curve"] = Json::array();
    for (const CurvePoint& point : measurement.curve)
        json["curve"].push_back(describe(point));
    return json;
}

Json describe(const Choice& choice, double scale, const std::string& command) {
    Json json;
    json["target_error"] = choice.target;
    const bool isKnown = choice.measurement != nullptr;
    json["options"] = isKnown ? Json(choice.options) : Json();
    json["seconds"] = isKnown ? Json(choice.seconds) : Json();
    json["seconds_at_scene_size"] = isKnown ? Json(scale * choice.seconds) : Json();
    json["seconds_by_default"] = orNull(choice.usual);
    json["extrapolated"] = choice.isExtrapolated;
    json["command"] = isKnown ? Json(commandOf(choice, command)) : Json();
    return json;
}

} // namespace

std::string toJson(const Study& study, const StudyOrigin& origin) {
    Json json = newJsonDocument();
    json["scene"] = origin.scene;
    json["device"] = origin.device;
    json["resolution"] = {study.usual.width, study.usual.height};
    json["ground_truth"] = {{"spp", study.groundTruth->samples},
                            {"stated_error", study.groundTruth->error},
                            {"trusted", study.groundTruth->isTrusted}};
    json["timing_noise"] = study.timingNoise();
    json["recommended"] = Json::array();
    for (const Choice& choice : choicesOf(study))
        json["recommended"].push_back(describe(choice, study.scale, origin.command));
    json["recommended_denoised"] = Json::array();
    for (const Choice& choice : denoisedChoicesOf(study))
        json["recommended_denoised"].push_back(describe(choice, study.scale, origin.command));
    json["omitted"] = Json::array();
    for (const FailedVariant& variant : study.omitted)
        json["omitted"].push_back({{"name", variant.name}, {"reason", variant.reason}});
    json["measurements"] = Json::array();
    for (const Measurement& measurement : study.measurements)
        json["measurements"].push_back(describe(measurement));
    return jsonText(json);
}

} // namespace calotype
