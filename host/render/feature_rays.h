#pragma once

#include <cstdint>

namespace calotype {

/// Rays of each pixel that its features are the mean of: edges are as smooth as in the picture, and
/// reflections are almost free of noise.
inline constexpr uint32_t kFeatureRays = 32;

/// The seed of the rays of features, for a picture's seed. They must share no random numbers with
/// the samples of the picture, or its denoised version is judged by what it was made from.
constexpr uint32_t featureSeed(uint32_t seed) {
    return seed ^ 0x9E3779B9u; // 2^32 over the golden ratio
}

} // namespace calotype
