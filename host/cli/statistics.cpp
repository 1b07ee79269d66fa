#include "cli/statistics.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

namespace calotype {

uint64_t peakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<uint64_t>(usage.ru_maxrss) * 1024; // Linux counts kibibytes
}

std::string toJson(const RenderStatistics& statistics) {
    const auto& [device, settings, totals, seconds, deviceBytes, sceneHash] = statistics;
    nlohmann::ordered_json json;
    json["version"] = CALOTYPE_VERSION;
    json["device"] = device.name;
    json["driver"] = device.driver;
    json["scene_hash"] = sceneHash;
    json["resolution"] = {settings.width, settings.height};
    json["crop"] = {settings.crop.x, settings.crop.y, settings.crop.width, settings.crop.height};
    json["spp"] = totals.samplesPerPixel;
    json["max_bounces"] = settings.maxBounces;
    json["seed"] = settings.seed;
    json["sampler"] = nameOf(settings.sampler);
    json["seconds"] = {{"load", seconds.load},
                       {"build", seconds.build},
                       {"upload", seconds.upload},
                       {"compile", seconds.compile},
                       {"first_sample", seconds.firstSample},
                       {"render", seconds.render},
                       {"write", seconds.write}};
    json["rays"] = totals.rays;
    json["paths"] = totals.paths;
    json["non_finite_samples"] = totals.nonFiniteSamples;
    json["cut_paths"] = totals.cutPaths;
    json["lost_blocks"] = totals.lostBlocks;
    json["device_memory_bytes"] = deviceBytes;
    json["peak_memory_bytes"] = peakMemoryBytes();
    return json.dump(2) + "\n";
}

} // namespace calotype
