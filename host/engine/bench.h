#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/stage_seconds.h"
#include "gpu/device_info.h"
#include "scene/scene.h"
#include "settings/device_options.h"
#include "settings/render_settings.h"

namespace calotype {

/// Samples per pixel of a repeat, if none are given.
inline constexpr uint32_t kBenchSamples = 4;

/// Statistics of repeated measurements.
struct Spread {
    double median = 0.0;
    double least = 0.0;
    double greatest = 0.0;
};

/// `numbers` must not be empty.
Spread spreadOf(std::vector<double> numbers);

/// Rays of one kind, traced without shading.
struct TraversalRate {
    std::string rays; ///< "primary", "bounced" or "shadow"
    uint64_t count = 0;
    Spread perSecond;
};

/// The measurements of one scene.
struct BenchReport {
    DeviceInfo device;
    RenderSettings settings; ///< `samplesPerPixel` is that of each repeat
    uint32_t repeats = 0;
    uint64_t primitives = 0;
    std::string tree; ///< as RenderEngine::tree
    Spread pathsPerSecond;
    Spread raysPerSecond;
    std::vector<TraversalRate> traversal;
    StageSeconds seconds;          ///< of the first picture; `firstSample` is their sum
    double firstPassSeconds = 0.0; ///< until every pixel had its first sample, without compiling
    uint64_t deviceBytes = 0;
};

/// Measures how fast a scene is rendered on a Vulkan device, `repeats` >= 1 times, after one time
/// that does not count. `loadSeconds` is the time that making the scene took. Throws GpuError,
/// SceneError, and Interrupted if `shouldStop` returned true.
BenchReport measureScene(const Scene& scene, const RenderSettings& settings, uint32_t repeats,
                         const DeviceOptions& device, double loadSeconds,
                         const std::function<bool()>& shouldStop);

} // namespace calotype
