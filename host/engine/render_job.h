#pragma once

#include <chrono>
#include <optional>

#include "engine/film_options.h"
#include "engine/output_options.h"
#include "settings/render_settings.h"

namespace calotype {

/// A render with the files that it reads and writes, for Renderer::render.
struct RenderJob {
    RenderSettings settings;
    /// False if only an error or a time is meant to end the render: progress then does not count
    /// samples.
    bool limitsSamples = true;
    FilmOptions film;
    OutputOptions output;
    bool returnsPixels = true; ///< false: RenderResult's pixels and alpha stay empty
    /// The start time for `settings.seconds` and the time of the first sample; none: the call.
    std::optional<std::chrono::steady_clock::time_point> start = {};
    double loadSeconds = 0.0; ///< time that reading the scene took, for the statistics
};

} // namespace calotype
