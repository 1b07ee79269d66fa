#pragma once

#include <glm/vec3.hpp>

#include "image/texel_image.h"

namespace calotype {

/// The mean colour of an image, alpha disregarded. `decode` makes sRGB-encoded colours linear
/// before the mean is taken, as a colour slot does.
glm::dvec3 meanColor(const TexelImage& image, bool decode);

} // namespace calotype
