// Bounds on rounding errors (Higham 2002, section 3.1) of float arithmetic as Vulkan guarantees it.
#ifndef CALOTYPE_CORE_ROUNDING_GLSL
#define CALOTYPE_CORE_ROUNDING_GLSL

/// Relative error of one operation: 2^-23, twice that of IEEE, because Vulkan does not fix the
/// rounding mode.
const float kUnitRoundoff = 1.1920929e-7;

/// Bound on the relative error of n operations in a row: n u / (1 - n u). A division (2.5 ULP)
/// counts as three operations, an inverse square root (2 ULP) as two.
#define GAMMA(n) ((n)*kUnitRoundoff / (1.0 - (n)*kUnitRoundoff))

#endif
