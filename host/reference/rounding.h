#pragma once

namespace calotype::reference {

/// Of one double operation, relative to its result.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// How far a point computed to lie on a surface may be off it, relative to the lengths that it was
/// computed from: into a shape's frame, onto its surface and back to the world are some sixteen
/// operations, and a ray's start and the surface that it left are both off. Times two.
inline constexpr double kSurfaceTolerance = 64.0 * kUnitRoundoff;

} // namespace calotype::reference
