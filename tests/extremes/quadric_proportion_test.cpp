// Cylinders and cones a hundred thousand times longer than wide, and wider than long: every kind of
// ray against extended precision, by backward error (gpu/quadric_errors.h).
#include <iostream>

#include "extremes/close_ups.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/primitive_scene.h"
#include "support/quadric_errors.h"
#include "support/test_quadrics.h"
#include "support/test_rays.h"

namespace calotype::test {
namespace {

void expectWithinRounding(const std::vector<shared::Quadric>& quadrics,
                          const std::vector<shared::TestRay>& rays) {
    const auto hits = PrimitiveScene::ofQuadrics(quadrics).hits(rays);
    QuadricErrors errors;
    size_t met = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        errors.add(quadrics[rays[i].primitive & ~shared::kQuadricBit], rays[i], hits[i]);
        met += hits[i].t < kFar ? 1 : 0;
    }
    std::cout << rays.size() << " rays, " << met << " hits, roundoffs " << errors.roundoffs
              << ", position " << errors.positionShare << " and normal " << errors.normalShare
              << " of what they may be, " << errors.disagreements << " decided otherwise\n";
    EXPECT_LE(errors.roundoffs, kAllowedRoundoffs) << errors.worstRay;
    EXPECT_LE(errors.positionShare, 1.0) << errors.worstPosition;
    EXPECT_LE(errors.normalShare, 1.0);
}

struct Parameter {
    uint32_t kind;
    double proportion;
    uint32_t raysPerQuadric;
};

void PrintTo(const Parameter& parameter, std::ostream* stream) {
    *stream << parameter.raysPerQuadric << " rays a quadric";
}

class QuadricProportionTest : public GpuTest, public testing::WithParamInterface<Parameter> {};

TEST_P(QuadricProportionTest, EveryKindOfRayHitsASurfaceWithinRounding) {
    const auto [kind, proportion, raysPerQuadric] = GetParam();
    for (const RayKind rayKind : kAllRayKinds) {
        SCOPED_TRACE(nameOf(rayKind));
        RandomNumbers random(static_cast<uint32_t>(rayKind));
        const std::vector<shared::Quadric> quadrics = variedQuadrics(kind, random, proportion);
        std::vector<shared::TestRay> rays;
        for (uint32_t i = 0; i < quadrics.size() * raysPerQuadric; ++i) {
            const uint32_t index = i / raysPerQuadric;
            const AimedRay ray = aimRay(rayKind, quadrics[index], random);
            rays.push_back(testRay(ray.origin, ray.direction, index | shared::kQuadricBit));
        }
        expectWithinRounding(quadrics, rays);
    }
}

// Most rays of the kinds above pass by what is so thin.
TEST_P(QuadricProportionTest, CloseUpRaysHitASurfaceWithinRounding) {
    const auto [kind, proportion, raysPerQuadric] = GetParam();
    RandomNumbers random(241);
    const auto quadrics = closeUpQuadrics(kind, proportion, random);
    std::vector<shared::TestRay> rays;
    for (uint32_t i = 0; i < quadrics.size() * raysPerQuadric; ++i)
        rays.push_back(closeUpRay(quadrics, i / raysPerQuadric, random));
    expectWithinRounding(quadrics, rays);
}

class ThinQuadricTest : public GpuTest {};

// Where the radius of a side is less than a rounding of its coordinates, a step along the side is
// one away from it: at the apex of a cone, and all along a cylinder.
TEST_F(ThinQuadricTest, PositionsFarFromTheOriginAreAsExactAsTheySay) {
    constexpr uint32_t kRaysPerQuadric = 1000;
    for (const uint32_t kind : {shared::kCylinder, shared::kCone}) {
        SCOPED_TRACE(nameOf(kind));
        RandomNumbers random(242);
        const double proportion = kind == shared::kCylinder ? 1e3 : 1e-3;
        std::vector<shared::Quadric> quadrics = variedQuadrics(kind, random, proportion);
        std::vector<shared::TestRay> rays;
        for (uint32_t index = 0; index < quadrics.size(); ++index) {
            shared::Quadric& quadric = quadrics[index];
            quadric.center = glm::vec3(2e3 * double(quadric.radius) * random.direction());
            if (kind == shared::kCylinder)
                quadric.radius *= 1e-5f;
            for (uint32_t i = 0; i < kRaysPerQuadric; ++i) {
                const AimedRay ray = aimRay(RayKind::Apex, quadric, random);
                rays.push_back(testRay(ray.origin, ray.direction, index | shared::kQuadricBit));
            }
        }
        expectWithinRounding(quadrics, rays);
    }
}

std::vector<Parameter> parameters(uint32_t raysPerQuadric) {
    std::vector<Parameter> all;
    for (const uint32_t kind : {shared::kCylinder, shared::kCone})
        for (const double proportion : {1e-5, 1e-3, 1e3, 1e5})
            all.push_back({kind, proportion, raysPerQuadric});
    return all;
}

std::string nameOfInstance(const testing::TestParamInfo<Parameter>& instance) {
    return nameOf(instance.param.kind) + proportionName(instance.param.proportion);
}

INSTANTIATE_TEST_SUITE_P(Of, QuadricProportionTest, testing::ValuesIn(parameters(200)),
                         nameOfInstance);
INSTANTIATE_TEST_SUITE_P(SlowOf, QuadricProportionTest, testing::ValuesIn(parameters(1000)),
                         nameOfInstance);

} // namespace
} // namespace calotype::test
