#pragma once

#include <cmath>
#include <numbers>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/quadric.h"

/// Functions for the texture coordinates of quadrics (docs/models.md, "Texture coordinates").
namespace calotype::reference {

/// atan2(z, x) in turns, in [0, 1). The sign of a zero does not matter.
inline double turnsAboutY(const glm::dvec3& p) {
    const double turns = std::atan2(p.z + 0.0, p.x + 0.0) / (2.0 * std::numbers::pi);
    const double positive = turns < 0.0 ? turns + 1.0 : turns;
    return positive < 1.0 ? positive : 0.0;
}

/// dp/du for u = turnsAboutY.
inline glm::dvec3 derivativeByTurns(const glm::dvec3& p) {
    return 2.0 * std::numbers::pi * glm::dvec3(-p.z, 0.0, p.x);
}

/// A circle around the y axis through p; texture coordinates are the square around it.
inline LocalSurface flatFace(const glm::dvec3& p, double radius, double outward) {
    return {p,
            {0.0, outward, 0.0},
            {0.5 + 0.5 * p.x / radius, 0.5 + 0.5 * p.z / radius},
            {2.0 * radius, 0.0, 0.0},
            {0.0, 0.0, 2.0 * radius}};
}

} // namespace calotype::reference
