#pragma once

#include "image/image.h"

namespace calotype {

/// The colour scale of a difference picture: falseColor of the logarithm of the relative
/// difference.
struct DifferenceScale {
    static constexpr double kLeast = 1e-4; ///< falseColor(0)
    static constexpr double kMost = 1.0;   ///< falseColor(1), and above
    static constexpr glm::u8vec3 kBelow{0, 0, 0};
    static constexpr glm::u8vec3 kInfinite{0, 255, 255}; ///< the pixel is infinite in A or B
};

/// A picture of the differences of A from B; both have one size and no NaN. The relative difference
/// of a pixel is the root of the mean of its channels' relativeSquaredError; so the mean of its
/// square over the picture is the relative MSE.
Rgb8Image differencePicture(const Image& a, const Image& b);

} // namespace calotype
