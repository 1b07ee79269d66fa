#pragma once

namespace calotype::reference {

/// Rounding error of one double operation, relative to its result.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// How far a point computed on a surface may be off it, relative to the lengths that it was
/// computed from: about sixteen operations into a shape's frame, onto its surface and back to the
/// world; both the ray's origin and the surface that it left have this error. Times two.
inline constexpr double kSurfaceTolerance = 64.0 * kUnitRoundoff;

} // namespace calotype::reference
