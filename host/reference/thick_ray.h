#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "math/bounds.h"
#include "reference/ray.h"
#include "reference/rounding.h"

namespace calotype::reference {

/// A ray as thick as all its rounding errors, so that it hits the bounding box of every shape that
/// it hits: the shape and the box are computed within a few operations on coordinates no larger
/// than those of the origin and of the scene together.
class ThickRay {
public:
    /// `sceneMagnitude` is the largest coordinate in the scene.
    ThickRay(const Ray& ray, double sceneMagnitude) {
        const glm::dvec3 o = glm::abs(ray.origin);
        const double magnitude = sceneMagnitude + std::max({o.x, o.y, o.z});
        const glm::dvec3 halfWidth(kSurfaceTolerance * magnitude);
        upperSide_ = ray.origin + halfWidth;
        lowerSide_ = ray.origin - halfWidth;
        // Infinite if the ray does not move on an axis: then all planes are infinitely far ahead or
        // behind. For a plane exactly at a side the result is NaN, and either answer is correct,
        // because that side is never reached.
        inverse_ = 1.0 / ray.direction;
    }

    /// Whether part of the ray up to t = `reach` is in the box.
    bool meets(const Bounds3d& box, double reach) const {
        const glm::dvec3 toLower = (box.lower - upperSide_) * inverse_;
        const glm::dvec3 toUpper = (box.upper - lowerSide_) * inverse_;
        const glm::dvec3 enter = glm::min(toLower, toUpper);
        const glm::dvec3 leave = glm::max(toLower, toUpper);
        return std::max({enter.x, enter.y, enter.z, 0.0}) <=
               std::min({leave.x, leave.y, leave.z, reach});
    }

private:
    glm::dvec3 upperSide_;
    glm::dvec3 lowerSide_;
    glm::dvec3 inverse_;
};

} // namespace calotype::reference
