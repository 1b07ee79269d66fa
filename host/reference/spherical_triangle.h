#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace calotype::reference {

/// A triangle as seen from the origin (docs/models.md, "Triangle light"). Corners are in metres.
struct SeenTriangle {
    glm::dvec3 a;
    glm::dvec3 b;
    glm::dvec3 c;

    /// In steradians, 0 to 2 pi; 0 if it is seen edge on.
    double solidAngle() const;

    /// Whether `direction` is used: the same rule as on the device, where single precision sets it.
    bool isSampledBySolidAngle() const;

    /// A unit vector towards the triangle, uniform in its solid angle; u in [0, 1)^2.
    glm::dvec3 direction(const glm::dvec2& u) const;
};

} // namespace calotype::reference
