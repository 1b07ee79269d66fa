#pragma once

#include <cmath>

namespace calotype {

/// The largest magnitude of texture coordinates, and of the factors and offsets that textures apply
/// to them. Floats of that size lie 64 apart, so that every coordinate reads the same texel; the
/// products of a few still keep far from the end of float's range (3.4e38).
constexpr double kLargestUv = 1e9;

/// The end of a sentence that refuses a number beyond it.
constexpr const char* kMustBeUv =
    "must lie in [-1e9, 1e9], beyond which single precision tells no two texels apart";

/// False also of what is not a number.
inline bool isUv(double number) { return std::abs(number) <= kLargestUv; }

} // namespace calotype
