#pragma once

#include <glm/gtc/type_precision.hpp>

namespace calotype {

/// A colour of sRGB for a position in [0, 1], clamped: from dark blue by violet, crimson and orange
/// to light yellow. Equal steps look equally large and grow lighter: the colours lie on a helix
/// around the grey axis of Oklab, whose speed is constant. (Oklab: Ottosson 2020,
/// https://bottosson.github.io/posts/oklab/)
glm::u8vec3 falseColor(double position);

} // namespace calotype
