#pragma once

#include "image/image.h"

namespace calotype {

/// Removes the noise of pictures of one scene, seen by one camera.
class Denoiser {
public:
    virtual ~Denoiser() = default;

    /// `color` is radiance, W/(m^2 sr), finite. The result depends on `color` alone, not on earlier
    /// calls. Throws Error if it fails.
    virtual Image run(const Image& color) = 0;
};

} // namespace calotype
