#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/statistics.h"
#include "gpu/device_list.h"
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

/// What `calotype bench` measured of one scene.
struct BenchReport {
    std::string scene;
    DeviceInfo device;
    uint32_t threads = 0; ///< of a CPU as device; 0: all cores
    RenderSettings settings;
    uint32_t repeats = 0;
    bool compilesEverything = false; ///< of the kernel
    uint64_t primitives = 0;
    Spread pathsPerSecond;
    Spread raysPerSecond;
    std::vector<TraversalRate> traversal;
    StageSeconds seconds;          ///< of the first picture; `firstSample` is their sum
    double firstPassSeconds = 0.0; ///< until every pixel had its first sample, after compiling
    uint64_t deviceBytes = 0;
};

/// A few lines for people.
std::string toText(const BenchReport& report);

/// One line, ended.
std::string toJsonLine(const BenchReport& report);

} // namespace calotype
