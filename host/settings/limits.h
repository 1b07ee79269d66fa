#pragma once

#include <cstdint>

namespace calotype {

inline constexpr uint32_t kMostSamplesPerPixel = 1u << 26;
inline constexpr uint32_t kMostBounces = 1u << 20;
inline constexpr double kMostSeconds = 1e9; ///< about thirty years

} // namespace calotype
