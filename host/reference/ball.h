#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "reference/interval.h"

namespace calotype::reference {

/// Where the line origin + t direction (unit length) runs inside the ball |p| <= radius about 0, of
/// three dimensions or, as a circle, of two. A start within `tolerance` of the surface is on it.
///
/// Half way between both crossings the line is nearest to the centre; from there, half a chord away
/// (Pythagoras), lie both.
template <int N>
Interval insideBall(const glm::vec<N, double>& origin, const glm::vec<N, double>& direction,
                    double radius, double tolerance) {
    const double toMiddle = -glm::dot(origin, direction);
    if (std::abs(glm::length(origin) - radius) <= tolerance)
        return Interval::between(0.0, 2.0 * toMiddle);
    const double middleFromCenter = glm::length(origin + toMiddle * direction);
    if (middleFromCenter > radius)
        return Interval::nowhere();
    const double halfChord = std::sqrt((radius - middleFromCenter) * (radius + middleFromCenter));
    return {toMiddle - halfChord, toMiddle + halfChord};
}

} // namespace calotype::reference
