#pragma once

#include <cstdint>

namespace calotype {

/// How the BVH is built.
enum class BvhBuilder : uint8_t {
    Median, ///< by halves of equal count; quick to build
    Sah,    ///< by the surface area heuristic; quick to traverse
};

/// The name in options.
constexpr const char* nameOf(BvhBuilder builder) {
    return builder == BvhBuilder::Median ? "median" : "sah";
}

} // namespace calotype
