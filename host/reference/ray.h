#pragma once

#include <limits>

#include <glm/vec3.hpp>

namespace calotype::reference {

/// The points origin + t direction for t in (0, length). World space, metres.
struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction; ///< unit length
    double length = std::numeric_limits<double>::infinity();
};

} // namespace calotype::reference
