#pragma once

#include <cmath>
#include <limits>

#include "math/bounds.h"

namespace calotype {

/// The largest float not above x.
inline float roundDown(double x) {
    const auto f = static_cast<float>(x);
    return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

/// The smallest float not below x.
inline float roundUp(double x) {
    const auto f = static_cast<float>(x);
    return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// The smallest box of floats that contains a box of doubles.
inline Bounds3f roundOutward(const Bounds3d& b) {
    return {{roundDown(b.lower.x), roundDown(b.lower.y), roundDown(b.lower.z)},
            {roundUp(b.upper.x), roundUp(b.upper.y), roundUp(b.upper.z)}};
}

} // namespace calotype
