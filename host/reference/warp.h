#pragma once

#include <cmath>
#include <numbers>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// Maps the unit square to disks, triangles, spheres and hemispheres.
namespace calotype::reference {

inline constexpr double kPi = std::numbers::pi;

/// Uniform on the unit disk: r = sqrt(u1), phi = 2 pi u2.
inline glm::dvec2 warpToDisk(const glm::dvec2& u) {
    const double r = std::sqrt(u.x);
    const double phi = 2.0 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// Uniform on a triangle: weights of corners two and three (docs/models.md, "Triangle light").
inline glm::dvec2 warpToTriangle(const glm::dvec2& u) {
    const double root = std::sqrt(u.x);
    return {root * (1.0 - u.y), root * u.y};
}

/// The unit vector at height z, at an angle of `turns` about the z axis.
inline glm::dvec3 directionAt(double z, double turns) {
    const double r = std::sqrt(std::fmax(1.0 - z * z, 0.0));
    const double phi = 2.0 * kPi * turns;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Uniform on the unit sphere. Density 1 / (4 pi).
inline glm::dvec3 warpToSphere(const glm::dvec2& u) { return directionAt(1.0 - 2.0 * u.x, u.y); }

/// Cosine-weighted about +z (docs/models.md, "Lambert"). Density cos / pi.
inline glm::dvec3 warpToCosineHemisphere(const glm::dvec2& u) {
    return directionAt(std::sqrt(1.0 - u.x), u.y);
}

/// A rotation whose third column is the unit vector n (Duff et al. 2017, "Building an Orthonormal
/// Basis, Revisited"): the same as on the device, so that equal numbers give equal directions.
inline glm::dmat3 frameAbout(const glm::dvec3& n) {
    const double sign = n.z >= 0.0 ? 1.0 : -1.0;
    const double a = -1.0 / (sign + n.z);
    const glm::dvec3 x(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
    const glm::dvec3 y(n.x * n.y * a, sign + n.y * n.y * a, -n.y);
    return {x, y, n};
}

} // namespace calotype::reference
