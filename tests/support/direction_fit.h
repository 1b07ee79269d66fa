#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

namespace calotype::test {

/// How well directions that a BSDF drew fit the density that it claims.
struct DirectionFit {
    double integral = 0.0; ///< of the density over the upper hemisphere
    double accepted = 0.0; ///< share of the draws that gave a direction
    double tolerance =
        0.0; ///< of that share: 1.95 / sqrt(draws), almost four standard errors of one half
    double chiSquare = 0.0; ///< of the directions, over cells of half vectors
    double limit = 0.0;     ///< which the statistic stays below but for once in 30,000 times
};

/// `wi` are the directions of `draws` draws, in the shading frame like the viewer's `wo`; `pdf` is
/// their density per solid angle. `lobeWidth` is the tangent of the half vector's angle on which
/// the density varies.
DirectionFit fitDirections(const std::vector<glm::dvec3>& wi, size_t draws, const glm::dvec3& wo,
                           double lobeWidth, const std::function<double(const glm::dvec3&)>& pdf);

} // namespace calotype::test
