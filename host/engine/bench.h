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

/// What repeats of one measurement gave.
struct Spread {
    double median = 0.0;
    double least = 0.0;
    double greatest = 0.0;
};

/// Of at least one number.
Spread spreadOf(std::vector<double> numbers);

/// Rays of one kind, traced without shading.
struct TraversalRate {
    std::string rays; ///< "primary", "bounced" or "shadow"
    uint64_t count = 0;
    Spread perSecond;
};

/// What is measured of one scene.
struct BenchReport {
    DeviceInfo device;
    RenderSettings settings; ///< `samplesPerPixel` is of each repeat
    uint32_t repeats = 0;
    uint64_t primitives = 0;
    Spread pathsPerSecond;
    Spread raysPerSecond;
    std::vector<TraversalRate> traversal;
    StageSeconds seconds;          ///< of the first picture; `firstSample` is their sum
    double firstPassSeconds = 0.0; ///< until every pixel had its first sample, after compiling
    uint64_t deviceBytes = 0;
};

/// Measures how fast a scene is rendered on a Vulkan device, `repeats` >= 1 times after once that
/// is not counted; `loadSeconds` are what making the scene took. Throws GpuError, SceneError, and
/// Interrupted where `shouldStop` returned true.
BenchReport measureScene(const Scene& scene, const RenderSettings& settings, uint32_t repeats,
                         const DeviceOptions& device, double loadSeconds,
                         const std::function<bool()>& shouldStop);

} // namespace calotype
