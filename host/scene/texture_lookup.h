#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "scene/texture.h"

namespace calotype {

/// RGB and alpha at `uv`, in double precision: filtered, wrapped, scaled and shifted as the texture
/// says. Colours of encoded images are decoded from sRGB before they are filtered, if `decodes`. A
/// coordinate of 1e300 or more, where no texel can be told from another, counts as 0.
glm::dvec4 lookUp(const Texture& texture, const glm::dvec2& uv, bool decodes);

/// The first channel, never decoded: what a height is read from.
double lookUpScalar(const Texture& texture, const glm::dvec2& uv);

} // namespace calotype
