#pragma once

#include <algorithm>

#include <glm/vec3.hpp>

namespace calotype {

/// The largest component.
inline double greatest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

} // namespace calotype
