#pragma once

#include <cstdint>
#include <string>

#include "support/kernels/test_structs.h"

/// The shaders' hits of quadrics against the oracle, by backward error: an answer is right if it is
/// the exact answer for a surface of which every face was moved by at most a tolerance of
///     n 2^-23 (distance of the origin from the centre + size),
/// for a cone more towards the apex (roundingScale).
/// So a hit may be missed or invented only where the ray passes that near to a silhouette or a rim,
/// and t may be off only by as much as that moves the crossing. The largest n is derived from
/// localRay and the discriminants: 4 roundings for the local origin, 2 for the direction, 3 for the
/// moment and 3 for the discriminant, whose error is relative to the distance of the origin; then 2
/// each for root, quotient and t, which are relative to t.
namespace calotype::test {

constexpr double kAllowedRoundoffs = 16.0;

/// The worst of many hits.
struct QuadricErrors {
    double roundoffs = 0.0;     ///< n above
    double positionShare = 0.0; ///< distance from the face, as a share of the stated error
    double normalShare = 0.0;   ///< error of the normal, as a share of what it may be
    uint32_t disagreements = 0; ///< hits where exact arithmetic misses, and the other way round
    std::string worstRay;
    std::string worstPosition;

    void add(const shared::Quadric& quadric, const shared::TestRay& ray,
             const shared::TestHit& hit);
};

} // namespace calotype::test
