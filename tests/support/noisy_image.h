#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "denoise/denoiser.h"
#include "image/denoiser_features.h"
#include "math/square.h"

namespace calotype::test {

inline Image constantImage(uint32_t width, uint32_t height, const glm::vec3& color) {
    Image image(width, height);
    std::ranges::fill(image.pixels, color);
    return image;
}

/// A picture whose noise is known: the same standard error in every pixel and channel.
inline NoisyImage withError(const Image& color, float standardError, size_t replicas = 8) {
    return {color, constantImage(color.width, color.height, glm::vec3(standardError)), replicas};
}

inline DenoiserFeatures noFeatures(const Image& image) {
    return {Image(image.width, image.height), Image(image.width, image.height)};
}

/// The mean of replicas, each of which is `value(x, y, channel, random)`, with the standard error
/// that their spread gives.
template <typename Value>
NoisyImage noisyImage(uint32_t width, uint32_t height, size_t replicas, uint32_t seed,
                      const Value& value) {
    std::mt19937 random(seed);
    NoisyImage noisy{Image(width, height), Image(width, height), replicas};
    const auto count = static_cast<double>(replicas);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                double sum = 0.0;
                double squares = 0.0;
                for (size_t i = 0; i < replicas; ++i) {
                    const double number = value(x, y, channel, random);
                    sum += number;
                    squares += square(number);
                }
                const double spread = std::max(squares - square(sum) / count, 0.0);
                noisy.color.at(x, y)[channel] = static_cast<float>(sum / count);
                noisy.standardError.at(x, y)[channel] =
                    static_cast<float>(std::sqrt(spread / (count * (count - 1.0))));
            }
    return noisy;
}

} // namespace calotype::test
