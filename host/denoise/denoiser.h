#pragma once

#include <cstddef>
#include <string>

#include "image/image.h"

namespace calotype {

/// The mean of several pictures from independent samples, and what their spread says of its noise.
struct NoisyImage {
    Image color;         ///< radiance, W/(m^2 sr), finite
    Image standardError; ///< of each channel of `color`; it has no pixels if it is not known
    size_t replicas = 0; ///< 1 more than the degrees of freedom of `standardError`, >= 2
};

/// Removes the noise of pictures of one scene, seen by one camera.
class Denoiser {
public:
    virtual ~Denoiser() = default;

    /// As files name it, with its version if it has one.
    virtual std::string name() const = 0;

    /// The result depends on `noisy` alone, not on earlier calls. Throws Error if it fails.
    virtual Image run(const NoisyImage& noisy) = 0;
};

} // namespace calotype
