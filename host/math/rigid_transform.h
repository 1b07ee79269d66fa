#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace calotype {

/// p_target = rotation * p_source + translation. `rotation` is orthogonal; its determinant is -1 if
/// the user's transform mirrors.
struct RigidTransform {
    glm::dmat3 rotation{1.0};
    glm::dvec3 translation{0.0};

    glm::dvec3 point(const glm::dvec3& p) const { return rotation * p + translation; }
    glm::dvec3 direction(const glm::dvec3& d) const { return rotation * d; }
};

} // namespace calotype
