#pragma once

#include <cstdint>

namespace calotype {

/// How a path's random numbers are drawn.
enum class Sampler : uint8_t {
    Independent, ///< each for itself
    Sobol,       ///< Owen-scrambled points, in pairs
};

/// As users spell it.
inline const char* nameOf(Sampler sampler) {
    return sampler == Sampler::Sobol ? "sobol" : "independent";
}

} // namespace calotype
