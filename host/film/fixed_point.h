#pragma once

#include <cmath>
#include <cstdint>

namespace calotype {

/// A signed number with 64 bits after the point, in (-2^63, 2^63). Addition is exact.
using FixedPoint = __int128;

/// The largest magnitude that toFixedPoint takes: 2^23 terms below it fit in a sum.
inline constexpr double kFixedPointTermLimit = 0x1p40;

/// Rounds to the nearest multiple of 2^-64, halves away from zero. `value` is a float times a power
/// of two, so it has 24 significant bits, and the result is exact from 2^-41 up; its magnitude is
/// at most kFixedPointTermLimit.
inline FixedPoint toFixedPoint(double value) {
    // Two steps of 62 bits, each within int64. The first remainder is exact: it is some of the bits
    // of `value`. Adding the half is inexact only from 2^52 up, where `low` is an even integer and
    // the sum is rounded to it.
    const double scaled = value * 0x1p2;
    const auto high = static_cast<int64_t>(scaled);
    const double low = (scaled - static_cast<double>(high)) * 0x1p62;
    return (FixedPoint{high} << 62) + static_cast<int64_t>(low + std::copysign(0.5, low));
}

/// The nearest double.
inline double fromFixedPoint(FixedPoint value) { return static_cast<double>(value) * 0x1p-64; }

} // namespace calotype
