#include "reference/spherical_triangle.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "reference/warp.h"

namespace calotype::reference {
namespace {

/// |a . (b x c)| of the unit vectors to the corners.
double determinant(const SeenTriangle& seen) {
    const double sixVolumes = glm::dot(seen.a, glm::cross(seen.b - seen.a, seen.c - seen.a));
    return std::abs(sixVolumes) / (glm::length(seen.a) * glm::length(seen.b) * glm::length(seen.c));
}

double angleBetween(const glm::dvec3& v, const glm::dvec3& w) {
    return std::atan2(glm::length(glm::cross(v, w)), glm::dot(v, w));
}

/// The direction, perpendicular to the unit vector `from`, in which the arc to `to` begins.
glm::dvec3 startOfArc(const glm::dvec3& from, const glm::dvec3& to) {
    return glm::normalize(glm::cross(glm::cross(from, to), from));
}

glm::dvec3 onArc(const glm::dvec3& from, const glm::dvec3& start, double angle) {
    return std::cos(angle) * from + std::sin(angle) * start;
}

} // namespace

double SeenTriangle::solidAngle() const {
    const glm::dvec3 p = glm::normalize(a);
    const glm::dvec3 q = glm::normalize(b);
    const glm::dvec3 r = glm::normalize(c);
    return 2.0 *
           std::atan2(determinant(*this), 1.0 + glm::dot(p, q) + glm::dot(q, r) + glm::dot(r, p));
}

bool SeenTriangle::isSampledBySolidAngle() const {
    return determinant(*this) >= 0x1p-47 && solidAngle() <= 2.0 * kPi - 1.0 / 16.0;
}

/// By spherical trigonometry: two sides x and y with the angle B between them span the area w, with
///     tan(w/2) = tan(x/2) tan(y/2) sin B / (1 + tan(x/2) tan(y/2) cos B).
/// Of the part with the share u2 of the area, y is the side from a to b and x that from b towards
/// c.
glm::dvec3 SeenTriangle::direction(const glm::dvec2& u) const {
    const glm::dvec3 toA = glm::normalize(a);
    const glm::dvec3 toB = glm::normalize(b);
    const glm::dvec3 towardsC = startOfArc(toB, glm::normalize(c));
    const double atB = angleBetween(startOfArc(toB, toA), towardsC);
    const double halfArea = 0.5 * u.y * solidAngle();
    const double side =
        2.0 * std::atan2(std::sin(halfArea),
                         std::tan(0.5 * angleBetween(toA, toB)) * std::sin(atB - halfArea));
    const glm::dvec3 onEdge = onArc(toB, towardsC, side);
    // On the arc from a to the edge, 1 - cos = 2 sin^2(angle / 2) has the share u1.
    const double angle =
        2.0 * std::asin(std::sqrt(u.x) * std::sin(0.5 * angleBetween(toA, onEdge)));
    return onArc(toA, startOfArc(toA, onEdge), angle);
}

} // namespace calotype::reference
