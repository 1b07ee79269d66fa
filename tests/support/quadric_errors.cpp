#include "support/quadric_errors.h"

#include <algorithm>
#include <cmath>

#include "support/device_numbers.h"
#include "support/oracle_quadric.h"
#include "support/primitive_scene.h"

namespace calotype::test {
namespace {

/// The smallest power of two of roundoffs for which the answer is allowed; 2^30 if none is.
double neededRoundoffs(const shared::Quadric& quadric, const shared::TestRay& ray, float t) {
    const Line line = lineOf(ray);
    const Real scale = roundingScale(quadric, line, t == kFar ? kInfinity : Real(t));
    double roundoffs = 0.5;
    for (; roundoffs < 0x1p30; roundoffs *= 2.0) {
        const AllowedAnswers allowed = allowedAnswers(quadric, line, roundoffs * kRoundoff * scale);
        if (t == kFar ? allowed.miss : allowed.contains(t))
            break;
    }
    return roundoffs;
}

} // namespace

void QuadricErrors::add(const shared::Quadric& quadric, const shared::TestRay& ray,
                        const shared::TestHit& hit) {
    const bool exactlyHit = firstHit(quadric, lineOf(ray)) < kInfinity;
    disagreements += exactlyHit != (hit.t < kFar) ? 1 : 0;
    const double needed = neededRoundoffs(quadric, ray, hit.t);
    if (needed > roundoffs) {
        roundoffs = needed;
        worstRay = describe(quadric, ray, hit.t);
    }
    if (hit.t == kFar)
        return;
    const FaceAt face = faceAt(quadric, Vec3(hit.position), Vec3(hit.ng));
    const auto share = static_cast<double>(std::abs(face.distance) / hit.error);
    if (!(share <= positionShare)) {
        positionShare = share;
        worstPosition = describe(quadric, ray, hit.t);
    }
    // A point on a curved face that is known to within s has a normal known to within s / radius.
    const Real rounding = glm::length(Vec3(ray.origin) - Vec3(quadric.center)) + reachOf(quadric) +
                          glm::length(Vec3(hit.position));
    const Real allowed =
        8.0L * kRoundoff * (1.0L + (face.isCurved ? rounding / face.radius : 0.0L));
    const auto normalError = static_cast<double>(glm::length(face.normal - Vec3(hit.ng)) / allowed);
    normalShare = normalError <= normalShare ? normalShare : normalError;
}

} // namespace calotype::test
