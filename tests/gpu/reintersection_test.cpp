#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/oracle_quadric.h"
#include "support/primitive_scene.h"
#include "support/test_quadrics.h"
#include "support/test_rays.h"

// Rays that leave a surface, from where offsetFromSurface puts them. To the outside they never meet
// the convex shape again; to the inside they meet its far side and nothing before. A disk has two
// outsides. Where two faces meet within rounding, at a rim or an apex, the point moved inward by
// the one may lie outside the other, or too near to it to decide.

namespace calotype::test {
namespace {

constexpr double kAllowedRoundoffs = 16.0; ///< as in quadric_hit_test.cpp

struct Departure {
    const shared::Quadric* quadric;
    double side; ///< 1: outward, -1: inward
    shared::TestRay ray;
};

bool isAimedAtAnEdge(RayKind kind) {
    return kind == RayKind::Grazing || kind == RayKind::Rim || kind == RayKind::Apex ||
           kind == RayKind::FacePlane;
}

std::vector<shared::TestRay> arrivals(const std::vector<shared::Quadric>& quadrics, bool atEdges,
                                      RandomNumbers& random) {
    constexpr uint32_t kRaysEach = 300;
    std::vector<shared::TestRay> rays;
    for (uint32_t index = 0; index < quadrics.size(); ++index) {
        for (const RayKind kind : kAllRayKinds) {
            for (uint32_t i = 0; i < kRaysEach && isAimedAtAnEdge(kind) == atEdges; ++i) {
                const AimedRay ray = aimRay(kind, quadrics[index], random);
                rays.push_back(testRay(ray.origin, ray.direction, index | shared::kQuadricBit));
            }
        }
    }
    return rays;
}

/// A direction on the side of `normal`; every other one grazing, down to a cosine of 1e-6.
glm::dvec3 departingDirection(const glm::dvec3& normal, RandomNumbers& random) {
    const glm::dvec3 direction = random.direction();
    const double cosine = glm::dot(direction, normal);
    const glm::dvec3 tangent = glm::normalize(direction - cosine * normal);
    const double wanted = random.coin() ? std::abs(cosine) : random.powerOfTen(-6.0, 0.0);
    return std::sqrt(1.0 - wanted * wanted) * tangent + wanted * normal;
}

std::vector<Departure> departuresFrom(const PrimitiveScene& scene,
                                      const std::vector<shared::TestRay>& arriving,
                                      RandomNumbers& random) {
    const std::vector<shared::TestHit> hits = scene.hits(arriving);
    std::vector<shared::TestOffset> points;
    std::vector<Departure> departures;
    for (const shared::TestHit& hit : hits) {
        if (hit.t == kFar)
            continue;
        const double side = random.sign();
        const glm::vec3 normal = static_cast<float>(side) * hit.ng;
        points.push_back({hit.position, hit.error, normal, 0.0f});
        const uint32_t index = hit.primitive & ~shared::kQuadricBit;
        departures.push_back(
            {&scene.packed().quadrics[index], side,
             testRay({}, departingDirection(glm::normalize(glm::dvec3(normal)), random),
                     hit.primitive)});
    }
    const std::vector<glm::vec3> origins = offsetPoints(points);
    for (size_t i = 0; i < departures.size(); ++i)
        departures[i].ray.origin = origins[i];
    return departures;
}

Real toleranceOf(const Departure& departure, float t) {
    const Real at = t == kFar ? kInfinity : Real(t);
    return kAllowedRoundoffs * kRoundoff *
           roundingScale(*departure.quadric, lineOf(departure.ray), at);
}

/// Whether an inward ray's answer is its far side, the surface being off by rounding at most.
bool isFarSide(const Departure& departure, float t) {
    const Line line = lineOf(departure.ray);
    const Real tolerance = toleranceOf(departure, t);
    const Interval shrunk = insideQuadric(*departure.quadric, line, -tolerance);
    return t <= insideQuadric(*departure.quadric, line, tolerance).leave &&
           (shrunk.isEmpty() || t >= shrunk.leave);
}

struct Mistakes {
    uint32_t selfHits = 0;   ///< of rays to the outside
    uint32_t wrongSide = 0;  ///< inward rays that do not start inside
    uint32_t escapes = 0;    ///< inward rays that meet nothing
    uint32_t wrongPlace = 0; ///< inward rays that meet something else than the far side
    std::string example;

    void add(uint32_t& counter, const Departure& departure, float t) {
        ++counter;
        example = describe(*departure.quadric, departure.ray, t);
    }
};

using Parameter = std::tuple<uint32_t, bool>;

class ReintersectionTest : public GpuTest, public testing::WithParamInterface<Parameter> {};

TEST_P(ReintersectionTest, HappensAtTheFarSideOnly) {
    const auto [kind, atEdges] = GetParam();
    RandomNumbers random(kind);
    const std::vector<shared::Quadric> quadrics = variedQuadrics(kind, random);
    const PrimitiveScene scene = PrimitiveScene::ofQuadrics(quadrics);
    const std::vector<Departure> departures =
        departuresFrom(scene, arrivals(quadrics, atEdges, random), random);
    std::vector<shared::TestRay> rays;
    for (const Departure& departure : departures)
        rays.push_back(departure.ray);
    const std::vector<shared::TestHit> hits = scene.hits(rays);

    Mistakes mistakes;
    for (size_t i = 0; i < rays.size(); ++i) {
        const Departure& departure = departures[i];
        const float t = hits[i].t;
        if (departure.side > 0.0 || kind == shared::kDisk) {
            if (t < kFar)
                mistakes.add(mistakes.selfHits, departure, t);
            continue;
        }
        const bool startsInside =
            insideQuadric(*departure.quadric, lineOf(rays[i]), 0.0L).contains(0.0L);
        const AllowedAnswers allowed =
            allowedAnswers(*departure.quadric, lineOf(rays[i]), toleranceOf(departure, t));
        if (!startsInside)
            ++mistakes.wrongSide;
        if (t == kFar && (atEdges ? !allowed.miss : startsInside))
            mistakes.add(mistakes.escapes, departure, t);
        if (t < kFar && (atEdges ? !allowed.contains(t) : !isFarSide(departure, t)))
            mistakes.add(mistakes.wrongPlace, departure, t);
    }
    RecordProperty("rays", std::to_string(rays.size()));
    RecordProperty("wrongSide", std::to_string(mistakes.wrongSide));
    EXPECT_EQ(mistakes.selfHits, 0u) << mistakes.example;
    EXPECT_EQ(mistakes.escapes, 0u) << mistakes.example;
    EXPECT_EQ(mistakes.wrongPlace, 0u) << mistakes.example;
    EXPECT_TRUE(atEdges || mistakes.wrongSide == 0) << mistakes.wrongSide;
}

INSTANTIATE_TEST_SUITE_P(Of, ReintersectionTest,
                         testing::Combine(testing::ValuesIn(kAllQuadricKinds), testing::Bool()),
                         [](const auto& instance) {
                             return nameOf(std::get<0>(instance.param)) +
                                    (std::get<1>(instance.param) ? "AtEdges" : "OnFaces");
                         });

} // namespace
} // namespace calotype::test
