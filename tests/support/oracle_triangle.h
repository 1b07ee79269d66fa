#pragma once

#include "shared/scene_structs.h"
#include "support/oracle_line.h"

namespace calotype::test {

/// Where a line crosses a triangle's plane, and how far inside the triangle.
struct TriangleCrossing {
    Real t = kInfinity;
    Real insideBy = -kInfinity; ///< distance of the line to the nearest edge, negative outside
    Real reach = 0.0L;          ///< distance of the farthest corner from the origin
    /// By how much a sideways error is magnified along the line: 1 for a triangle that is met
    /// squarely, large for needles and for triangles seen nearly edge on.
    Real magnification = 1.0L;
    Vec2 barycentrics{}; ///< weights of the second and third corner
};
TriangleCrossing crossTriangle(const shared::Triangle& triangle, const Line& line);

} // namespace calotype::test
