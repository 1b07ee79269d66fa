#pragma once

/// Numbers of the device's arithmetic, by which tests measure.
namespace calotype::test {

inline constexpr double kRoundoffOfFloat = 0x1p-23;
inline constexpr float kFar = 1e19f; ///< of shaders/core/constants.glsl: no hit

} // namespace calotype::test
