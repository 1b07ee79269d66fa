#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "reference/ray.h"

namespace calotype::reference {

using Corners = std::array<glm::dvec3, 3>; ///< counter-clockwise, seen from the front

/// A ray, and two directions that are perpendicular to it and to each other: a projection along the
/// ray.
class View {
public:
    explicit View(const Ray& ray);

    const glm::dvec3& origin() const { return origin_; }
    /// Two coordinates across the ray and the depth along it.
    glm::dvec3 operator()(const glm::dvec3& point) const;

private:
    glm::dvec3 origin_;
    glm::dvec3 right_;
    glm::dvec3 up_;
    glm::dvec3 forward_;
};

struct TriangleHit {
    double t;           ///< > 0
    glm::dvec3 weights; ///< of the three corners; their sum is 1
};

/// The crossing of the ray, of any length, with the triangle. None if it starts in the plane.
std::optional<TriangleHit> intersect(const Corners& corners, const View& view);

/// Unit length, towards the front.
glm::dvec3 normalOf(const Corners& corners);

double areaOf(const Corners& corners);

/// The weights of the corners at a point that is on the triangle up to rounding: the relative areas
/// opposite to them.
glm::dvec3 weightsAt(const Corners& corners, const glm::dvec3& point);

} // namespace calotype::reference
