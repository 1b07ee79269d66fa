#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "image/image.h"

namespace calotype {

/// Mean of each channel over the pixels. Throws Error if there are none.
glm::dvec3 imageMean(const Image& image);

/// (t - r)^2 / (r^2 + 0.01): the squared error of a channel relative to the reference, with a floor
/// that keeps dark pixels from dominating.
double relativeSquaredError(double test, double reference);

/// Mean over pixels and channels of relativeSquaredError. Throws Error if the sizes differ or are
/// 0.
double relativeMse(const Image& test, const Image& reference);

/// The picture `factor` times smaller, each pixel the mean of a square of factor x factor. Throws
/// Error if factor is 0 or does not divide both sides.
Image boxDownsample(const Image& image, uint32_t factor);

} // namespace calotype
