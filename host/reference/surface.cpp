#include "reference/surface.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace calotype::reference {

glm::dvec3 offsetFrom(const glm::dvec3& from, const glm::dvec3& normalOnThatSide) {
    constexpr double kUnitInTheLastPlace = 0x1p-52; // from 1 to 2: relatively the largest
    const double magnitude = std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
    return from + 32.0 * kUnitInTheLastPlace * magnitude * normalOnThatSide;
}

glm::dvec3 leaveSurface(const Surface& surface, const glm::dvec3& w) {
    const double side = glm::dot(w, surface.ng) < 0.0 ? -1.0 : 1.0;
    return offsetFrom(surface.position, side * surface.ng);
}

} // namespace calotype::reference
