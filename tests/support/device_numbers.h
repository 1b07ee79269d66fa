#pragma once

/// What the device's arithmetic knows and the tests measure by.
namespace calotype::test {

inline constexpr double kRoundoffOfFloat = 0x1p-23;
inline constexpr float kFar = 1e19f; ///< of shaders/core/constants.glsl: no hit

} // namespace calotype::test
