#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "image/image.h"

namespace calotype::test {

/// Mean of each channel over the pixels. Throws Error if there are none.
glm::dvec3 imageMean(const Image& image);

/// The picture `factor` times smaller, each pixel the mean of a square of factor x factor. Throws
/// Error if factor is 0 or does not divide both sides.
Image boxDownsample(const Image& image, uint32_t factor);

} // namespace calotype::test
