#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/texture.h"

namespace calotype {

/// RGB and alpha at `uv`, in double precision, with the texture's filter, wrapping, scale and
/// offset. If `decodes`, colours of encoded images are decoded from sRGB before filtering. A
/// coordinate of 1e300 or more, at which texels have no meaning, counts as 0.
glm::dvec4 lookUp(const Texture& texture, const glm::dvec2& uv, bool decodes);

/// The linear colour at `uv` of an image whose texels are weighted by their alpha too (see
/// hasCutOutColors); where all of them are transparent, their mean without alpha.
glm::dvec3 lookUpCutOutColor(const Texture& texture, const glm::dvec2& uv);

/// The first channel, never decoded: for heights.
double lookUpScalar(const Texture& texture, const glm::dvec2& uv);

} // namespace calotype
