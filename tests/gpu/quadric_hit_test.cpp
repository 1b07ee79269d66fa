#include "gpu/primitive_scene.h"
#include "support/gpu_test.h"
#include "support/oracle_quadric.h"
#include "support/test_quadrics.h"
#include "support/test_rays.h"

// The hits of the shaders' quadrics against the oracle, by backward error: an answer is right if it
// is the exact answer for a surface of which every face was moved by at most a tolerance of
//     n 2^-23 (distance of the origin from the centre + size),
// for a cone more towards the apex (roundingScale).
// So a hit may be missed or invented only where the ray passes that near to a silhouette or a rim,
// and t may be off only by as much as that moves the crossing. The largest n is derived from
// localRay and the discriminants: 4 roundings for the local origin, 2 for the direction, 3 for the
// moment and 3 for the discriminant, whose error is relative to the distance of the origin; then 2
// each for root, quotient and t, which are relative to t.

namespace calotype::test {
namespace {

constexpr double kAllowedRoundoffs = 16.0;
constexpr float kFar = 1e19f;

struct ShapeErrors {
    double roundoffs = 0.0;     ///< n above
    double positionShare = 0.0; ///< distance from the face, as a share of the stated error
    double normalShare = 0.0;   ///< error of the normal, as a share of what it may be
    uint32_t disagreements = 0; ///< hits where exact arithmetic misses, and the other way round
    std::string worstRay;
    std::string worstPosition;
};

/// The smallest power of two of roundoffs for which the answer is allowed; 2^30 if none is.
double neededRoundoffs(const gpu::Quadric& quadric, const gpu::TestRay& ray, float t) {
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

void checkRay(const gpu::Quadric& quadric, const gpu::TestRay& ray, const gpu::TestHit& hit,
              ShapeErrors& errors) {
    const bool exactlyHit = firstHit(quadric, lineOf(ray)) < kInfinity;
    errors.disagreements += exactlyHit != (hit.t < kFar) ? 1 : 0;
    const double roundoffs = neededRoundoffs(quadric, ray, hit.t);
    if (roundoffs > errors.roundoffs) {
        errors.roundoffs = roundoffs;
        errors.worstRay = describe(quadric, ray, hit.t);
    }
    if (hit.t == kFar)
        return;
    const FaceAt face = faceAt(quadric, Vec3(hit.position), Vec3(hit.ng));
    const auto positionShare = static_cast<double>(std::abs(face.distance) / hit.error);
    if (positionShare > errors.positionShare) {
        errors.positionShare = positionShare;
        errors.worstPosition = describe(quadric, ray, hit.t);
    }
    // A point on a curved face that is known to within s has a normal known to within s / radius.
    const Real rounding = glm::length(Vec3(ray.origin) - Vec3(quadric.center)) + reachOf(quadric) +
                          glm::length(Vec3(hit.position));
    const Real allowed =
        8.0L * kRoundoff * (1.0L + (face.isCurved ? rounding / face.radius : 0.0L));
    errors.normalShare = std::max(
        errors.normalShare, static_cast<double>(glm::length(face.normal - Vec3(hit.ng)) / allowed));
}

class QuadricHit : public GpuTest,
                   public testing::WithParamInterface<std::tuple<uint32_t, RayKind>> {};

TEST_P(QuadricHit, IsThatOfASurfaceWithinRounding) {
    const auto [kind, rayKind] = GetParam();
    constexpr uint32_t kRaysPerQuadric = 1000;
    RandomNumbers random(1000 * kind + static_cast<uint32_t>(rayKind));
    const std::vector<gpu::Quadric> quadrics = variedQuadrics(kind, random);
    std::vector<gpu::TestRay> rays;
    for (uint32_t i = 0; i < quadrics.size() * kRaysPerQuadric; ++i) {
        const uint32_t index = i / kRaysPerQuadric;
        const AimedRay ray = aimRay(rayKind, quadrics[index], random);
        rays.push_back(testRay(ray.origin, ray.direction, index | gpu::kQuadricBit));
    }
    const auto hits = PrimitiveScene::ofQuadrics(quadrics).hits(rays);
    ShapeErrors errors;
    for (size_t i = 0; i < rays.size(); ++i)
        checkRay(quadrics[i / kRaysPerQuadric], rays[i], hits[i], errors);
    RecordProperty("roundoffs", std::to_string(errors.roundoffs));
    RecordProperty("positionShare", std::to_string(errors.positionShare));
    RecordProperty("normalShare", std::to_string(errors.normalShare));
    RecordProperty("disagreements", std::to_string(errors.disagreements));
    EXPECT_LE(errors.roundoffs, kAllowedRoundoffs) << errors.worstRay;
    EXPECT_LE(errors.positionShare, 1.0) << errors.worstPosition;
    EXPECT_LE(errors.normalShare, 1.0);
    if (rayKind == RayKind::Outside || (rayKind == RayKind::Inside && kind != gpu::kDisk)) {
        EXPECT_LE(errors.disagreements, 2u);
    }
}

INSTANTIATE_TEST_SUITE_P(All, QuadricHit,
                         testing::Combine(testing::ValuesIn(kAllQuadricKinds),
                                          testing::ValuesIn(kAllRayKinds)),
                         [](const auto& instance) {
                             return nameOf(std::get<0>(instance.param)) +
                                    nameOf(std::get<1>(instance.param));
                         });

} // namespace
} // namespace calotype::test
