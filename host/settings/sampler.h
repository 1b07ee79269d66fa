#pragma once

#include <cstdint>

namespace calotype {

/// How a path's random numbers are generated.
enum class Sampler : uint8_t {
    Independent, ///< independent random numbers
    Sobol,       ///< Owen-scrambled points, in pairs
};

/// The name in options.
constexpr const char* nameOf(Sampler sampler) {
    return sampler == Sampler::Sobol ? "sobol" : "independent";
}

} // namespace calotype
