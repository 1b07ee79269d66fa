#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "reference/interval.h"

namespace calotype::reference {

/// The interval of the line origin + t direction (unit length) in the ball |p| <= radius about 0,
/// in three dimensions or, as circle, in two. An origin within `tolerance` of the surface is on it.
///
/// Half way between the crossings the line is nearest to the centre; each crossing is half a chord
/// away from there (Pythagoras).
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
