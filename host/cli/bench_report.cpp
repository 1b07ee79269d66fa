#include "cli/bench_report.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "engine/json_document.h"
#include "engine/statistics.h"
#include "settings/settings_table.h"

namespace calotype {
namespace {

std::string rateText(const Spread& spread, const std::string& unit) {
    return withPrefix(spread.median) + " " + unit + "/s (" + withPrefix(spread.least) + " to " +
           withPrefix(spread.greatest) + ")";
}

std::string secondsText(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f s", seconds);
    return text;
}

std::string mebibytes(uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

nlohmann::ordered_json toJson(const Spread& spread) {
    return {{"median", spread.median}, {"min", spread.least}, {"max", spread.greatest}};
}

} // namespace

std::string toText(const std::string& scene, const BenchReport& report) {
    const RenderSettings& settings = report.settings;
    const StageSeconds& seconds = report.seconds;
    std::string text = scene + ": " + std::to_string(report.primitives) + " primitives, " +
                       std::to_string(settings.width) + "x" + std::to_string(settings.height) +
                       ", " + std::to_string(settings.samplesPerPixel) + " samples per pixel, " +
                       std::to_string(settings.maxBounces) + " bounces, on " + report.device.name +
                       "\n";
    text += "  paths         " + rateText(report.pathsPerSecond, "paths") + "\n";
    text += "  rays          " + rateText(report.raysPerSecond, "rays") + "\n";
    for (const TraversalRate& rate : report.traversal) {
        std::string name = rate.rays + " rays";
        name.resize(14, ' ');
        text += "  " + name + rateText(rate.perSecond, "rays") + ", traversal alone\n";
    }
    text += "  first sample  " + secondsText(seconds.firstSample) + ": load " +
            secondsText(seconds.load) + ", build " + secondsText(seconds.build) + ", upload " +
            secondsText(seconds.upload) + ", compile " + secondsText(seconds.compile) +
            ", sample " + secondsText(report.firstPassSeconds) + "\n";
    text += "  memory        " + mebibytes(report.deviceBytes) + " on the device, " +
            mebibytes(peakMemoryBytes()) + " of the process at most\n";
    return text;
}

std::string toJsonLine(const std::string& scene, const BenchReport& report, uint32_t threads) {
    nlohmann::ordered_json json = newJsonDocument();
    json["scene"] = scene;
    json["device"] = report.device.name;
    json["driver"] = report.device.driver;
    json["threads"] = threads > 0 ? nlohmann::ordered_json(threads) : nullptr;
    json["primitives"] = report.primitives;
    for (const Setting& setting : settingsTable())
        if (setting.changesSamples || (setting.commands & kBenchCommand))
            json[setting.name] = setting.value(report.settings);
    json["bvh"] = report.tree;
    json["repeats"] = report.repeats;
    json["paths_per_second"] = toJson(report.pathsPerSecond);
    json["rays_per_second"] = toJson(report.raysPerSecond);
    for (const TraversalRate& rate : report.traversal)
        json["traversal_rays_per_second"][rate.rays] = toJson(rate.perSecond);
    json["seconds"] = {
        {"load", report.seconds.load},           {"build", report.seconds.build},
        {"upload", report.seconds.upload},       {"compile", report.seconds.compile},
        {"first_pass", report.firstPassSeconds}, {"first_sample", report.seconds.firstSample}};
    json["device_memory_bytes"] = report.deviceBytes;
    json["peak_memory_bytes"] = peakMemoryBytes();
    return jsonText(json, -1);
}

} // namespace calotype
