#pragma once

#include <glm/vec3.hpp>

#include "read/json/value.h"

namespace calotype {

/// A colour as linear Rec. 709: [r, g, b], one number for grey, or "#rrggbb" (sRGB-encoded).
/// Throws SceneError unless every component lies in [0, 1].
glm::dvec3 readReflectance(const JsonValue& value);

/// The same notation for radiance (W/(m^2 sr)) or power (W): not negative, without an upper bound.
glm::dvec3 readRadiance(const JsonValue& value);

} // namespace calotype
