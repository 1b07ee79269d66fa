#pragma once

#include <cstdint>
#include <optional>

namespace calotype {

/// What ends a render: the first of these that is reached.
struct RenderPlan {
    uint64_t pixels = 0;
    uint64_t samplesBefore = 0;                   ///< per pixel, that need not be rendered
    std::optional<uint64_t> samplesPerPixel = {}; ///< those before among them
    std::optional<double> targetError = {};
    std::optional<double> seconds = {}; ///< from now
};

} // namespace calotype
