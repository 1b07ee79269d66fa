#include "engine/statistics.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "base/hexadecimal.h"
#include "engine/json_document.h"
#include "settings/settings_table.h"

namespace calotype {

namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(RenderEnding ending) {
    switch (ending) {
    case RenderEnding::AllSamples:
        return "samples";
    case RenderEnding::TargetError:
        return "target-error";
    case RenderEnding::Deadline:
        return "time";
    case RenderEnding::Stopped:
        break;
    }
    return "interrupt";
}

} // namespace

nlohmann::ordered_json describeError(const std::optional<ErrorEstimate>& error) {
    if (!error)
        return nullptr;
    nlohmann::ordered_json json;
    json["relative"] = error->relative;
    json["bound"] = error->upperBound();
    json["replicas"] = error->replicas;
    json["doubt"] = error->doubt ? nlohmann::ordered_json(*error->doubt) : nullptr;
    json["trusted"] = error->isTrusted();
    return json;
}

void describeDenoisedError(const std::optional<DenoisedError>& error,
                           nlohmann::ordered_json& json) {
    json["denoised_error"] = error ? Json(error->relative) : Json();
    json["denoised_bound"] = error ? Json(error->bound) : Json();
}

uint64_t peakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<uint64_t>(usage.ru_maxrss) * 1024; // in units of KiB on Linux
}

std::string toJson(const RenderStatistics& statistics) {
    const auto& [device, settings, sceneHash, totals, denoised, ending, seconds, deviceBytes,
                 tree] = statistics;
    nlohmann::ordered_json json = newJsonDocument();
    json["device"] = device.name;
    json["driver"] = device.driver;
    json["scene_hash"] = hexadecimal(sceneHash);
    json["resolution"] = {settings.width, settings.height};
    json["spp"] = totals.samplesPerPixel;
    json["ended_by"] = nameOf(ending);
    json["error"] = describeError(totals.error);
    describeDenoisedError(denoised, json);
    for (const Setting& setting : settingsTable())
        if ((setting.commands & kRenderCommand) && !json.contains(setting.name))
            json[setting.name] = setting.value(settings);
    json["bvh"] = tree;
    json["seconds"] = {{"load", seconds.load},         {"build", seconds.build},
                       {"upload", seconds.upload},     {"compile", seconds.compile},
                       {"features", seconds.features}, {"first_sample", seconds.firstSample},
                       {"render", seconds.render},     {"denoise", seconds.denoise},
                       {"write", seconds.write}};
    json["rays"] = totals.rays;
    json["paths"] = totals.paths;
    json["non_finite_samples"] = totals.losses.nonFiniteSamples;
    json["cut_paths"] = totals.losses.cutPaths;
    json["lost_blocks"] = totals.losses.lostPixels();
    json["device_memory_bytes"] = deviceBytes;
    json["peak_memory_bytes"] = peakMemoryBytes();
    return jsonText(json);
}

} // namespace calotype
