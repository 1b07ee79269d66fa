#pragma once

#include <cmath>
#include <numbers>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/quadric.h"

/// What the texture coordinates of several quadrics have in common (scene-format.md).
namespace calotype::reference {

/// atan2(z, x) in turns, in [0, 1). Either sign of a zero gives the same.
inline double turnsAboutY(const glm::dvec3& p) {
    const double turns = std::atan2(p.z + 0.0, p.x + 0.0) / (2.0 * std::numbers::pi);
    const double positive = turns < 0.0 ? turns + 1.0 : turns;
    return positive < 1.0 ? positive : 0.0;
}

/// dp/du where u is turnsAboutY.
inline glm::dvec3 derivativeByTurns(const glm::dvec3& p) {
    return 2.0 * std::numbers::pi * glm::dvec3(-p.z, 0.0, p.x);
}

/// A circle about the axis y through p, with the square around it as texture coordinates.
inline LocalSurface flatFace(const glm::dvec3& p, double radius, double outward) {
    return {p,
            {0.0, outward, 0.0},
            {0.5 + 0.5 * p.x / radius, 0.5 + 0.5 * p.z / radius},
            {2.0 * radius, 0.0, 0.0},
            {0.0, 0.0, 2.0 * radius}};
}

} // namespace calotype::reference
