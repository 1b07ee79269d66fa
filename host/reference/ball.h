#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "reference/interval.h"

namespace calotype::reference {

/// Where the line origin + t direction (unit length) runs inside the ball |p| <= radius about 0, of
/// three dimensions or, as a circle, of two. A start within `tolerance` of the surface is on it.
///
/// Half way between both crossings the line is nearest to the centre. From there, half a chord away
/// (Pythagoras), lies the crossing farther from the origin, a sum without cancellation. The other
/// follows from the product of both distances, the power of the origin: |o|^2 - radius^2. So the
/// signs of both are right however near to the surface the origin is.
template <int N>
Interval insideBall(const glm::vec<N, double>& origin, const glm::vec<N, double>& direction,
                    double radius, double tolerance) {
    const double toMiddle = -glm::dot(origin, direction);
    const double fromCenter = glm::length(origin);
    if (std::abs(fromCenter - radius) <= tolerance)
        return Interval::between(0.0, 2.0 * toMiddle);
    const double middleFromCenter = glm::length(origin + toMiddle * direction);
    if (middleFromCenter > radius)
        return Interval::nowhere();
    const double halfChord = std::sqrt((radius - middleFromCenter) * (radius + middleFromCenter));
    const double farther = toMiddle + std::copysign(halfChord, toMiddle);
    const double power = (fromCenter - radius) * (fromCenter + radius);
    return Interval::between(power / farther, farther);
}

} // namespace calotype::reference
