#pragma once

#include <cstdint>
#include <optional>

namespace calotype {

/// What ends a render: whichever of these is reached first.
struct RenderPlan {
    uint64_t pixels = 0;
    uint64_t samplesBefore = 0;                   ///< per pixel, from the film
    std::optional<uint64_t> samplesPerPixel = {}; ///< including those before
    std::optional<double> targetError = {};
    std::optional<double> seconds = {}; ///< from now
};

} // namespace calotype
