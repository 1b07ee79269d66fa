#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "denoise/denoised_error.h"
#include "engine/stage_seconds.h"
#include "gpu/device_info.h"
#include "render/session.h"
#include "settings/render_settings.h"

namespace calotype {

/// The data of a render for its statistics file.
struct RenderStatistics {
    DeviceInfo device;
    RenderSettings settings;
    uint64_t sceneHash = 0;
    RenderTotals totals;
    std::optional<DenoisedError> denoised; ///< none: not denoised, or not stated
    RenderEnding ending = RenderEnding::AllSamples;
    StageSeconds seconds;
    uint64_t deviceBytes = 0;
    const char* tree = ""; ///< RenderEngine::tree
};

/// The numbers of the estimate, or null if there is none.
nlohmann::ordered_json describeError(const std::optional<ErrorEstimate>& error);

/// Adds `denoised_error` and `denoised_bound`, or null.
void describeDenoisedError(const std::optional<DenoisedError>& error, nlohmann::ordered_json& json);

/// Of the process so far.
uint64_t peakMemoryBytes();

/// As JSON, with the process's peak memory.
std::string toJson(const RenderStatistics& statistics);

} // namespace calotype
