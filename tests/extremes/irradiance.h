#pragma once

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace calotype::test {

/// Irradiance at a point of a plane with normal +y from a polygon of radiance 1 above that plane,
/// its corners in either sense (Lambert 1760): half the sum of angle_i (edge normal_i . n).
inline double polygonIrradiance(const std::vector<glm::dvec3>& corners, const glm::dvec3& point) {
    double sum = 0.0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = corners[i] - point;
        const glm::dvec3 b = corners[(i + 1) % corners.size()] - point;
        const glm::dvec3 across = glm::cross(a, b);
        const double sine = glm::length(across);
        if (sine > 0.0) // an edge seen end on has no angle
            sum += std::atan2(sine, glm::dot(a, b)) * across.y / sine;
    }
    return 0.5 * std::abs(sum);
}

} // namespace calotype::test
