#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/film_keeper.h"
#include "engine/output_options.h"
#include "engine/render_plan.h"
#include "engine/stage_seconds.h"
#include "render/session.h"
#include "scene/scene.h"
#include "settings/device_options.h"
#include "settings/render_settings.h"

namespace calotype {

/// A render with the files that it reads and writes.
struct RenderJob {
    RenderSettings settings;
    /// Whether the number of samples ends the render even if an error or a time also does.
    bool limitsSamples = true;
    DeviceOptions device;
    FilmOptions film;
    OutputOptions output;
    /// The start time for `settings.seconds` and the time of the first sample.
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    double loadSeconds = 0.0; ///< time that reading the scene took, for the statistics
};

/// Callbacks of a running job, on the thread that called runRenderJob. None may be empty. An
/// exception from one ends the job.
struct RenderJobObserver {
    /// Called with the current step and its share done in [0, 1].
    std::function<void(const std::string& what, double done)> onStep;
    std::function<void(const RenderPlan&)> onStart; ///< sampling begins
    std::function<void(const RenderTotals&)> onDispatch;
    std::function<bool()> shouldStop;                  ///< called about ten times a second
    std::function<void(const std::string&)> onWarning; ///< a complete sentence
};

struct RenderOutcome {
    RenderTotals totals;
    RenderEnding ending = RenderEnding::AllSamples;
    RenderPlan plan;
    uint64_t cutPixels = 0; ///< of the layers of first hits
};

/// Renders a scene and writes every file. If an output cannot be written, the others still are.
/// Throws SettingError, SceneError, GpuError, OutputError, and Interrupted if it is stopped before
/// the first sample.
RenderOutcome runRenderJob(Scene scene, const RenderJob& job, const RenderJobObserver& observer);

} // namespace calotype
