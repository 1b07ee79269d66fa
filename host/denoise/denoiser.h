#pragma once

#include "image/image.h"

namespace calotype {

/// What the camera sees in each pixel, without the noise of light (shared::Features). Both have the
/// picture's size; they are black where nothing is seen.
struct DenoiserFeatures {
    Image albedo; ///< in [0, 1]
    Image normal; ///< in world space, towards the camera; of length 0 to 1
};

/// Removes the noise of pictures of one scene, seen by one camera.
class Denoiser {
public:
    virtual ~Denoiser() = default;

    /// `color` is radiance, W/(m^2 sr), of the size of the features. The result depends on `color`
    /// alone, not on earlier calls. Throws Error if it fails.
    virtual Image run(const Image& color) = 0;
};

} // namespace calotype
