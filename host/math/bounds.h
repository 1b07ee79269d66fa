#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace calotype {

/// Axis-aligned box, corners included. Default: empty.
template <typename T>
struct Bounds {
    glm::vec<3, T> lower{std::numeric_limits<T>::infinity()};
    glm::vec<3, T> upper{-std::numeric_limits<T>::infinity()};

    bool isEmpty() const { return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z; }
    glm::vec<3, T> extent() const { return upper - lower; }

    void extend(const glm::vec<3, T>& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    void extend(const Bounds& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    bool contains(const Bounds& other) const {
        return other.isEmpty() ||
               (glm::min(lower, other.lower) == lower && glm::max(upper, other.upper) == upper);
    }
};

using Bounds3f = Bounds<float>;
using Bounds3d = Bounds<double>;

/// Half the surface area of a box that is not empty.
template <typename T>
double halfArea(const Bounds<T>& bounds) {
    const glm::dvec3 e = glm::dvec3(bounds.upper) - glm::dvec3(bounds.lower);
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

} // namespace calotype
