#pragma once

#include <cmath>

namespace calotype {

/// Encodes linear light in [0, 1] for a display: the piecewise curve of IEC 61966-2-1.
inline float srgbFromLinear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// The inverse, of an encoded value in [0, 1].
inline double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace calotype
