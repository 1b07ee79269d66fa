// Mathematical constants.
#ifndef CALOTYPE_CORE_CONSTANTS_GLSL
#define CALOTYPE_CORE_CONSTANTS_GLSL

const float kPi = 3.14159265358979;
const float kTwoPi = 6.28318530717959;
const float kInvPi = 0.318309886183791;

/// The greatest number below 1.
const float kOneMinusEpsilon = 1.0 - 1.0 / 16777216.0;

/// Further than any hit; its square is still finite.
const float kFar = 1e19;

#endif
