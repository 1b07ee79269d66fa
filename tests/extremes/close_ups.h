#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "support/primitive_scene.h"
#include "support/test_quadrics.h"

namespace calotype::test {

/// Upright and turned ones of three scales about the world's origin, where positions are as fine as
/// they can be.
inline std::vector<shared::Quadric> closeUpQuadrics(uint32_t kind, double proportion,
                                                    RandomNumbers& random) {
    std::vector<shared::Quadric> quadrics = variedQuadrics(kind, random, proportion);
    for (shared::Quadric& quadric : quadrics)
        quadric.center = glm::vec3(0.0f);
    return quadrics;
}

/// The smallest measure of a cylinder or a cone.
inline double thinnestOf(const shared::Quadric& quadric) {
    return std::min(double(quadric.radius), std::abs(double(quadric.extent)));
}

/// A ray onto a random point of the surface, steeply, from as far off it as the quadric is thin.
inline shared::TestRay closeUpRay(const std::vector<shared::Quadric>& quadrics, uint32_t index,
                                  RandomNumbers& random) {
    const shared::Quadric& quadric = quadrics[index];
    const LocalPoint point = randomSurfacePoint(quadric, random);
    const glm::dvec3 outward =
        thinnestOf(quadric) * glm::normalize(point.normal + 0.7 * random.inBall());
    const glm::dvec3 target = worldPoint(quadric, point.position);
    const glm::dvec3 origin = worldPoint(quadric, point.position + outward);
    return testRay(origin, glm::normalize(target - origin), index | shared::kQuadricBit);
}

/// "1eminus5" and the like, for names of tests.
inline std::string proportionName(double proportion) {
    return std::string("1e") + (proportion < 1.0 ? "minus" : "plus") +
           std::to_string(std::abs(std::lround(std::log10(proportion))));
}

} // namespace calotype::test
