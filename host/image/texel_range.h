#pragma once

#include <glm/vec3.hpp>

#include "image/texel_image.h"

namespace calotype {

/// The least and the greatest value of red, green and blue over all texels of an image, bytes
/// scaled to [0, 1]; nothing is decoded.
struct TexelRange {
    glm::dvec3 least{0.0};
    glm::dvec3 greatest{0.0};
};

/// Of an image that is not empty.
TexelRange texelRange(const TexelImage& image);

} // namespace calotype
