// Rays that leave cylinders and cones of extreme proportions from where offsetFromSurface puts
// them: to the outside they never meet the convex shape again, to the inside always.
#include <iostream>

#include "check/thin_quadrics.h"
#include "extremes/close_ups.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/oracle_quadric.h"
#include "support/primitive_scene.h"
#include "support/quadric_errors.h"
#include "support/test_quadrics.h"

namespace calotype::test {
namespace {

constexpr uint32_t kRaysPerQuadric = 2000;

/// From points of the surface, along and against its normal and all between, down to a cosine of
/// 1e-3.
class Departures {
public:
    Departures(const std::vector<shared::Quadric>& quadrics, RandomNumbers& random) {
        const PrimitiveScene scene = PrimitiveScene::ofQuadrics(quadrics);
        std::vector<shared::TestRay> arriving;
        for (uint32_t i = 0; i < quadrics.size() * kRaysPerQuadric; ++i)
            arriving.push_back(closeUpRay(quadrics, i / kRaysPerQuadric, random));
        std::vector<shared::TestOffset> points;
        for (const shared::TestHit& hit : scene.hits(arriving)) {
            if (hit.t == kFar)
                continue;
            sides.push_back(random.sign());
            const glm::vec3 normal = static_cast<float>(sides.back()) * hit.ng;
            points.push_back({hit.position, hit.error, normal, 0.0f});
            rays.push_back(testRay({}, leaving(glm::dvec3(normal), random), hit.primitive));
        }
        const std::vector<glm::vec3> origins = offsetPoints(points);
        for (size_t i = 0; i < rays.size(); ++i)
            rays[i].origin = origins[i];
        hits = scene.hits(rays);
    }

    std::vector<double> sides; ///< 1: to the outside, -1: to the inside
    std::vector<shared::TestRay> rays;
    std::vector<shared::TestHit> hits;

private:
    static glm::dvec3 leaving(const glm::dvec3& normal, RandomNumbers& random) {
        const glm::dvec3 direction = random.direction();
        const double cosine = glm::dot(direction, normal);
        return glm::normalize(direction + (std::max(std::abs(cosine), 1e-3) - cosine) * normal);
    }
};

struct Mistakes {
    uint32_t rays = 0;
    uint32_t selfHits = 0;  ///< of rays to the outside
    uint32_t wrongSide = 0; ///< rays to the inside that start outside
    uint32_t escapes = 0;   ///< rays from inside that meet nothing
    std::string example;
};

/// Whether some surface within rounding of the quadric's is missed.
bool mayMiss(const shared::Quadric& quadric, const shared::TestRay& ray) {
    const Line line = lineOf(ray);
    const Real tolerance = kAllowedRoundoffs * kRoundoff * roundingScale(quadric, line, kInfinity);
    return allowedAnswers(quadric, line, tolerance).miss;
}

Mistakes mistakesOf(uint32_t kind, double proportion) {
    RandomNumbers random(231);
    const auto quadrics = closeUpQuadrics(kind, proportion, random);
    const Departures departures(quadrics, random);
    Mistakes mistakes;
    mistakes.rays = static_cast<uint32_t>(departures.rays.size());
    for (size_t i = 0; i < departures.rays.size(); ++i) {
        const shared::TestRay& ray = departures.rays[i];
        const shared::Quadric& quadric = quadrics[ray.primitive & ~shared::kQuadricBit];
        const bool hit = departures.hits[i].t < kFar;
        const bool isInside = insideQuadric(quadric, lineOf(ray), 0.0L).contains(0.0L);
        const bool outward = departures.sides[i] > 0.0;
        mistakes.selfHits += outward && hit ? 1 : 0;
        mistakes.wrongSide += !outward && !isInside ? 1 : 0;
        mistakes.escapes += !outward && isInside && !hit && !mayMiss(quadric, ray) ? 1 : 0;
        if (hit == outward)
            mistakes.example = describe(quadric, ray, departures.hits[i].t);
    }
    std::cout << mistakes.rays << " rays, " << mistakes.selfHits << " meet their own side, "
              << mistakes.wrongSide << " leave by the other face, " << mistakes.escapes
              << " escape\n";
    return mistakes;
}

using Parameter = std::tuple<uint32_t, double>;

class QuadricDepartureTest : public GpuTest, public testing::WithParamInterface<Parameter> {};

TEST_P(QuadricDepartureTest, NeitherMeetsItselfNorEscapes) {
    const auto [kind, proportion] = GetParam();
    const Mistakes mistakes = mistakesOf(kind, proportion);
    EXPECT_GT(mistakes.rays, 36u * kRaysPerQuadric / 2);
    EXPECT_EQ(mistakes.selfHits, 0u) << mistakes.example;
    EXPECT_EQ(mistakes.escapes, 0u) << mistakes.example;
    // Points are kept off the rims, so that moved inward by the one face they do not lie outside
    // the other. They are moved by 14 roundings of the radius at most, which takes a distance of
    // 28 slopes of these from the rim of a flat cone: more than the 64th that they are kept off
    // where the slope is above 4681. There, the cone is thinner than this along much of its rim.
    const bool isFlatCone = kind == shared::kCone && proportion > 4681.0;
    const double wedge = isFlatCone ? 14.0 * 0x1p-23 * proportion : 0.0;
    EXPECT_LE(mistakes.wrongSide, wedge * mistakes.rays / 2) << mistakes.example; // half go inward
    if (std::max(proportion, 1.0 / proportion) < 1.001 * kThinnestProportion)
        EXPECT_LE(mistakes.wrongSide, 1e-2 * mistakes.rays) << mistakes.example;
}

INSTANTIATE_TEST_SUITE_P(Of, QuadricDepartureTest,
                         testing::Combine(testing::Values(shared::kCylinder, shared::kCone),
                                          testing::Values(1e-5, 1e-4, 1e-3, 1e3, 1e4, 1e5)),
                         [](const auto& instance) {
                             return nameOf(std::get<0>(instance.param)) +
                                    proportionName(std::get<1>(instance.param));
                         });

} // namespace
} // namespace calotype::test
