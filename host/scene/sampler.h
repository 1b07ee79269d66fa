#pragma once

#include <cstdint>

namespace calotype {

/// How a path's random numbers are drawn.
enum class Sampler : uint8_t {
    Independent, ///< each for itself
    Sobol,       ///< Owen-scrambled points, in pairs
};

} // namespace calotype
