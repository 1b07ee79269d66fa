// Rays of every kind against quadrics of every kind, by backward error (gpu/quadric_errors.h).
#include "support/gpu_test.h"
#include "support/primitive_scene.h"
#include "support/quadric_errors.h"
#include "support/test_quadrics.h"
#include "support/test_rays.h"

namespace calotype::test {
namespace {

class QuadricHitTest : public GpuTest,
                       public testing::WithParamInterface<std::tuple<uint32_t, RayKind>> {};

TEST_P(QuadricHitTest, IsThatOfASurfaceWithinRounding) {
    const auto [kind, rayKind] = GetParam();
    constexpr uint32_t kRaysPerQuadric = 1000;
    RandomNumbers random(1000 * kind + static_cast<uint32_t>(rayKind));
    const std::vector<shared::Quadric> quadrics = variedQuadrics(kind, random);
    std::vector<shared::TestRay> rays;
    for (uint32_t i = 0; i < quadrics.size() * kRaysPerQuadric; ++i) {
        const uint32_t index = i / kRaysPerQuadric;
        const AimedRay ray = aimRay(rayKind, quadrics[index], random);
        rays.push_back(testRay(ray.origin, ray.direction, index | shared::kQuadricBit));
    }
    const auto hits = PrimitiveScene::ofQuadrics(quadrics).hits(rays);
    QuadricErrors errors;
    for (size_t i = 0; i < rays.size(); ++i)
        errors.add(quadrics[i / kRaysPerQuadric], rays[i], hits[i]);
    RecordProperty("roundoffs", std::to_string(errors.roundoffs));
    RecordProperty("positionShare", std::to_string(errors.positionShare));
    RecordProperty("normalShare", std::to_string(errors.normalShare));
    RecordProperty("disagreements", std::to_string(errors.disagreements));
    EXPECT_LE(errors.roundoffs, kAllowedRoundoffs) << errors.worstRay;
    EXPECT_LE(errors.positionShare, 1.0) << errors.worstPosition;
    EXPECT_LE(errors.normalShare, 1.0);
    if (rayKind == RayKind::Outside || (rayKind == RayKind::Inside && kind != shared::kDisk))
        EXPECT_LE(errors.disagreements, 2u);
}

INSTANTIATE_TEST_SUITE_P(All, QuadricHitTest,
                         testing::Combine(testing::ValuesIn(kAllQuadricKinds),
                                          testing::ValuesIn(kAllRayKinds)),
                         [](const auto& instance) {
                             return nameOf(std::get<0>(instance.param)) +
                                    nameOf(std::get<1>(instance.param));
                         });

} // namespace
} // namespace calotype::test
