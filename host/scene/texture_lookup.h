#pragma once

#include <glm/vec2.hpp>

#include "scene/texture.h"

namespace calotype {

/// The first channel of the texture at `uv`, never decoded from sRGB: what a height is read from.
/// Filtered, wrapped, scaled and shifted as the texture says, in double precision. A coordinate of
/// 1e300 or more, where no texel can be told from another, counts as 0.
double lookUpScalar(const Texture& texture, const glm::dvec2& uv);

} // namespace calotype
