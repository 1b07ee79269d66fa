#pragma once

#include <glm/gtc/type_precision.hpp>

namespace calotype {

/// An sRGB colour for a position in [0, 1], clamped: from dark blue through violet, crimson and
/// orange to light yellow. Equal steps look equally large and become lighter: the colours are on a
/// helix of constant speed around the grey axis of Oklab. (Oklab: Ottosson 2020,
/// https://bottosson.github.io/posts/oklab/)
glm::u8vec3 falseColor(double position);

} // namespace calotype
