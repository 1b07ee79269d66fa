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
    /// Whether the number of samples ends the render even where an error or a time does too.
    bool limitsSamples = true;
    DeviceOptions device;
    FilmOptions film;
    OutputOptions output;
    /// What `settings.seconds` and the time of the first sample count from.
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    double loadSeconds = 0.0; ///< that reading the scene took, for the statistics
};

/// What a job reports while it runs, on the thread that called runRenderJob. No function may be
/// empty; what they throw ends the job.
struct RenderJobObserver {
    /// What is being prepared, and the share of it done in [0, 1].
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

/// Renders a scene and writes every file. An output that cannot be written keeps no other from
/// being written. Throws SettingError, SceneError, GpuError, OutputError, and
/// Interrupted where it is stopped before the first sample.
RenderOutcome runRenderJob(Scene scene, const RenderJob& job, const RenderJobObserver& observer);

} // namespace calotype
