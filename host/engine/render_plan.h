#pragma once

#include <cstdint>
#include <optional>

#include "render/render_totals.h"

namespace calotype {

/// What ends a render: whichever of these is reached first.
struct RenderPlan {
    uint64_t pixels = 0;
    uint64_t samplesBefore = 0;                   ///< per pixel, from the film
    std::optional<uint64_t> samplesPerPixel = {}; ///< including those before
    std::optional<double> targetError = {};
    bool targetsDenoised = false;       ///< the target is for the picture after denoising
    std::optional<double> seconds = {}; ///< from the start of sampling
};

/// The share of a render that is done, in [0, 1], after `seconds` of sampling. With a target error
/// it is an estimate.
double shareDone(const RenderPlan& plan, const RenderTotals& totals, double seconds);

} // namespace calotype
