#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/options.h"
#include "film/film_file.h"
#include "gpu/device_list.h"
#include "render/session.h"
#include "settings/render_settings.h"

namespace calotype {

/// Wall-clock seconds of each stage of a render.
struct StageSeconds {
    double load = 0.0;
    double build = 0.0; ///< of the BVH, and packing
    double upload = 0.0;
    double compile = 0.0;
    double firstSample = 0.0; ///< from the start of the program until every pixel had one sample
    double render = 0.0;      ///< sampling alone
    double write = 0.0;
};

/// What --stats writes.
struct RenderStatistics {
    DeviceInfo device;
    RenderSettings settings;
    RenderTotals totals;
    RenderEnding ending = RenderEnding::AllSamples;
    StageSeconds seconds;
    uint64_t deviceBytes = 0;
    const FilmLabel& label;
    const char* tree = ""; ///< RenderEngine::tree
    bool adapts = false;   ///< samples go where the error is
};

/// The estimate's numbers, or null where there is none.
nlohmann::ordered_json describeError(const std::optional<ErrorEstimate>& error);

/// Of the process so far.
uint64_t peakMemoryBytes();

/// As JSON, with the process's peak memory.
std::string toJson(const RenderStatistics& statistics);

} // namespace calotype
