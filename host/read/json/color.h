#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "base/range.h"
#include "read/json/value.h"

namespace calotype {

/// A colour as linear Rec. 709: [r, g, b], one number for grey, or "#rrggbb" (sRGB-encoded). Throws
/// SceneError unless each channel is in `channel`.
glm::dvec3 readColor(const JsonValue& value, const Range& channel);

/// False for texts that start with '#', which are colours.
bool canBeTextureName(const std::string& text);

} // namespace calotype
