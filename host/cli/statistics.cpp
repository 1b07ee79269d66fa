#include "cli/statistics.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "base/hexadecimal.h"

namespace calotype {

namespace {

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

uint64_t peakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<uint64_t>(usage.ru_maxrss) * 1024; // Linux counts kibibytes
}

std::string toJson(const RenderStatistics& statistics) {
    const auto& [device, settings, totals, ending, seconds, deviceBytes, label, tree, adapts] =
        statistics;
    nlohmann::ordered_json json;
    json["version"] = CALOTYPE_VERSION;
    json["device"] = device.name;
    json["driver"] = device.driver;
    json["scene_hash"] = hexadecimal(label.sceneHash);
    json["resolution"] = {settings.width, settings.height};
    json["crop"] = {settings.crop.x, settings.crop.y, settings.crop.width, settings.crop.height};
    json["spp"] = totals.samplesPerPixel;
    json["adaptive"] = adapts;
    json["ended_by"] = nameOf(ending);
    json["error"] = describeError(totals.error);
    json["max_bounces"] = settings.maxBounces;
    json["seed"] = settings.seed;
    json["sampler"] = nameOf(settings.sampler);
    const TransportSettings& transport = settings.transport;
    json["mis"] = transport.usesMis;
    json["roulette"] = transport.usesRoulette;
    json["clamp_indirect"] =
        transport.clampsIndirect() ? nlohmann::ordered_json(transport.indirectClamp) : nullptr;
    json["light_choice"] = label.setting("light_choice");
    json["texture_filter"] = label.setting("texture_filter");
    json["bvh"] = tree;
    json["seconds"] = {{"load", seconds.load},
                       {"build", seconds.build},
                       {"upload", seconds.upload},
                       {"compile", seconds.compile},
                       {"first_sample", seconds.firstSample},
                       {"render", seconds.render},
                       {"write", seconds.write}};
    json["rays"] = totals.rays;
    json["paths"] = totals.paths;
    json["non_finite_samples"] = totals.losses.nonFiniteSamples;
    json["cut_paths"] = totals.losses.cutPaths;
    json["lost_blocks"] = totals.losses.lostPixels();
    json["device_memory_bytes"] = deviceBytes;
    json["peak_memory_bytes"] = peakMemoryBytes();
    return json.dump(2) + "\n";
}

} // namespace calotype
