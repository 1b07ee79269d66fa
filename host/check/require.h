#pragma once

#include <string>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "base/range.h"
#include "scene/ranges.h"

namespace calotype {

/// Each function throws SceneError at `where` if its condition does not hold.

/// "must be in [0, 1], not 2"
void require(const Range& range, double number, const std::string& where);
/// The same for each channel or component.
void require(const Range& range, const glm::dvec3& numbers, const std::string& where);
void require(const ranges::WholeRange& range, uint32_t number, const std::string& where);

/// The columns must be finite, of length 1 and perpendicular, up to rounding.
void requireOrthonormal(const glm::dmat3& axes, const std::string& where);

} // namespace calotype
