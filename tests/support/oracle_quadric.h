#pragma once

#include "shared/scene_structs.h"
#include "support/oracle_line.h"

namespace calotype::test {

/// What a correct tracer may answer for a ray: the parameter of a hit in one of two intervals, or a
/// miss. The wider they are, the more the surface was allowed to move.
struct AllowedAnswers {
    Interval entry;
    Interval exit;
    bool miss = false;

    bool contains(Real t) const { return t > 0.0L && (entry.contains(t) || exit.contains(t)); }
};

/// A world line in the frame of a quadric, by the packed axes, taken as exact.
Line localLine(const shared::Quadric& quadric, const Line& world);

/// Largest distance of a point of the quadric from its `center`.
Real reachOf(const shared::Quadric& quadric);

/// The length to which the roundings of an intersection at t (infinity: none) are relative: that of
/// the coordinates seen from the quadric. A cone's quadratic form gets as flat towards the apex as
/// the point is near to it, compared with the cone's size, and its surface is as much less certain.
Real roundingScale(const shared::Quadric& quadric, const Line& world, Real t);

/// Where a world line runs inside a sphere, cylinder or cone whose surface moved outward by
/// `growth` (negative: inward).
Interval insideQuadric(const shared::Quadric& quadric, const Line& world, Real growth);

/// The answers for a ray (t > 0) if every face of the quadric may be off by `tolerance`.
AllowedAnswers allowedAnswers(const shared::Quadric& quadric, const Line& world, Real tolerance);

/// The exact first hit, or infinity.
Real firstHit(const shared::Quadric& quadric, const Line& world);

/// The face of a quadric to which a world point with a given normal belongs.
struct FaceAt {
    Real distance; ///< signed, of the point from the face
    Vec3 normal;   ///< exact, outward
    bool isCurved;
    Real radius; ///< of a curved face: distance of the point from the axis, or from the centre
};
FaceAt faceAt(const shared::Quadric& quadric, const Vec3& world, const Vec3& normal);

} // namespace calotype::test
