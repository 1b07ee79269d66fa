// Texture coordinates on quadrics and disks, and the directions in which they grow, against the
// scene format's words in double.
#include <cmath>

#include "gpu/coordinates_at.h"
#include "support/oracle_coordinates.h"
#include "support/test_quadrics.h"

namespace calotype::test {
namespace {

/// That angleInTurns states; the angle of v counts twice.
constexpr double kAngleError = 1e-7;

/// The distance between two numbers of a circle of length 1.
double aroundCircle(double a, double b) {
    const double difference = std::abs(a - b);
    return std::min(difference, 1.0 - difference);
}

/// A quadric near the origin, at some scale, upright or turned, of any proportion.
std::vector<shared::Quadric> nearbyQuadrics(uint32_t kind, RandomNumbers& random) {
    std::vector<shared::Quadric> quadrics = variedQuadrics(kind, random);
    for (shared::Quadric& quadric : quadrics)
        quadric.center = glm::vec3(random.inBall() * double(quadric.radius));
    return quadrics;
}

double sizeOf(const shared::Quadric& quadric) { return quadric.radius + std::abs(quadric.extent); }

/// Rays that meet each quadric from about its size away, steeply.
std::vector<shared::TestRay> raysOnto(const std::vector<shared::Quadric>& quadrics, int raysEach,
                                      RandomNumbers& random) {
    std::vector<shared::TestRay> rays;
    for (uint32_t i = 0; i < quadrics.size(); ++i)
        for (int k = 0; k < raysEach; ++k) {
            const LocalPoint point = randomSurfacePoint(quadrics[i], random);
            const glm::dvec3 outward =
                sizeOf(quadrics[i]) * glm::normalize(point.normal + 0.7 * random.inBall());
            const glm::dvec3 target = worldPoint(quadrics[i], point.position);
            const glm::dvec3 origin = worldPoint(quadrics[i], point.position + outward);
            rays.push_back(
                testRay(origin, glm::normalize(target - origin), i | shared::kQuadricBit));
        }
    return rays;
}

class QuadricCoordinatesTest : public GpuTest, public testing::WithParamInterface<uint32_t> {
protected:
    /// Calls check(quadric, isOnFlatFace, hit, point, error) for every hit that clearly lies on one
    /// face: `point` is the hit in the quadric's frame, `error` bounds how far off it may be: 16
    /// roundings of the distances in play, as for hits.
    template <typename Check>
    void forEachHit(const Check& check) {
        RandomNumbers random(111);
        const auto quadrics = nearbyQuadrics(GetParam(), random);
        const auto rays = raysOnto(quadrics, 400, random);
        const auto results = coordinatesAt(PrimitiveScene::ofQuadrics(quadrics), rays);
        size_t checked = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const shared::Quadric& quadric = quadrics[rays[i].primitive & ~shared::kQuadricBit];
            const glm::dvec3 point = localPoint(quadric, glm::dvec3(results[i].position));
            const double error = 16.0 * kRoundoffOfFloat * 3.0 * sizeOf(quadric);
            const NearestFace face = nearestFace(quadric, point);
            if (face.margin < 4.0 * error)
                continue;
            ++checked;
            check(quadric, face.isFlat, results[i], point, error);
            if (HasFailure())
                return;
        }
        EXPECT_GT(checked, rays.size() * 9 / 10);
    }
};

TEST_P(QuadricCoordinatesTest, AreTheFormats) {
    forEachHit([](const shared::Quadric& quadric, bool isFlat, const shared::TestCoordinates& hit,
                  const glm::dvec3& point, double error) {
        const glm::dvec2 wanted = oracleCoordinates(quadric, isFlat, point);
        const double radius = std::hypot(point.x, point.z);
        const double scaleOfV = quadric.kind == shared::kSphere ? quadric.radius
                                : isFlat                        ? 2.0 * quadric.radius
                                                                : std::abs(quadric.extent);
        const double errorU = kAngleError + error / (isFlat ? 2.0 * quadric.radius : radius);
        ASSERT_NEAR(isFlat ? std::abs(hit.u - wanted.x) : aroundCircle(hit.u, wanted.x), 0.0,
                    errorU);
        ASSERT_NEAR(hit.v, wanted.y, 2.0 * kAngleError + error / scaleOfV);
        if (!isFlat) {
            ASSERT_GE(hit.u, 0.0f);
            ASSERT_LT(hit.u, 1.0f);
        }
    });
}

TEST_P(QuadricCoordinatesTest, GrowAlongTheirDirections) {
    forEachHit([](const shared::Quadric& quadric, bool isFlat, const shared::TestCoordinates& hit,
                  const glm::dvec3& point, double error) {
        const double radius = std::hypot(point.x, point.z);
        if (!isFlat && radius < 1e-3 * quadric.radius)
            return; // towards a pole or an apex u has no direction
        const double step = 1e-5 * std::min(radius, sizeOf(quadric));
        const auto slope = [&](const glm::dvec3& world) {
            const glm::dvec3 local = localPoint(quadric, glm::dvec3(quadric.center) + world);
            const glm::dvec2 ahead = oracleCoordinates(quadric, isFlat, point + step * local);
            const glm::dvec2 behind = oracleCoordinates(quadric, isFlat, point - step * local);
            glm::dvec2 difference = ahead - behind;
            difference.x -= std::round(difference.x); // across the seam
            return difference / (2.0 * step);
        };
        const double turned = isFlat ? 0.0 : error / radius;
        expectGrowth(hit, slope, 16.0 * kRoundoffOfFloat + 4.0 * turned + 1e-9);
    });
}

TEST_P(QuadricCoordinatesTest, GrowAlongTheSurface) {
    forEachHit([](const shared::Quadric& quadric, bool isFlat, const shared::TestCoordinates& hit,
                  const glm::dvec3& point, double error) {
        const double radius = std::hypot(point.x, point.z);
        glm::dvec3 normal(0.0, 1.0, 0.0);
        if (!isFlat && quadric.kind == shared::kSphere)
            normal = glm::normalize(point);
        if (!isFlat && quadric.kind != shared::kSphere)
            normal = {point.x / radius,
                      quadric.kind == shared::kCone ? -quadric.slope * std::copysign(1.0, point.y)
                                                    : 0.0,
                      point.z / radius};
        if (!isFlat && radius < 1e-3 * quadric.radius)
            return;
        const glm::dvec3 world =
            glm::normalize(worldPoint(quadric, normal) - glm::dvec3(quadric.center));
        const double tolerance = 16.0 * kRoundoffOfFloat + (isFlat ? 0.0 : 4.0 * error / radius);
        EXPECT_NEAR(glm::dot(unit(hit.dpdu), world), 0.0, tolerance);
        EXPECT_NEAR(glm::dot(unit(hit.dpdv), world), 0.0, tolerance);
    });
}

// Where u has no direction the answers are numbers all the same.
TEST_P(QuadricCoordinatesTest, AreFiniteOnTheAxis) {
    std::vector<shared::Quadric> quadrics;
    for (const float extent : {1.5f, -1.5f}) {
        shared::Quadric quadric{};
        quadric.kind = GetParam();
        quadric.axisX = {1, 0, 0};
        quadric.axisY = {0, 1, 0};
        quadric.axisZ = {0, 0, 1};
        quadric.slope = 0.5f;
        quadric.radius = 0.75f;
        quadric.extent = GetParam() == shared::kCone ? extent : 1.5f;
        quadrics.push_back(quadric);
    }
    std::vector<shared::TestRay> rays;
    for (uint32_t i = 0; i < 2; ++i)
        for (const double side : {1.0, -1.0})
            rays.push_back(
                testRay({0.0, 4.0 * side, 0.0}, {0.0, -side, 0.0}, i | shared::kQuadricBit));
    for (const auto& hit : coordinatesAt(PrimitiveScene::ofQuadrics(quadrics), rays)) {
        EXPECT_LT(hit.t, 10.0f);
        EXPECT_TRUE(hit.u >= 0.0f && hit.u <= 1.0f && hit.v >= 0.0f && hit.v <= 1.0f);
        EXPECT_TRUE(std::isfinite(glm::dot(hit.dpdu, hit.dpdu) + glm::dot(hit.dpdv, hit.dpdv)));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, QuadricCoordinatesTest, testing::ValuesIn(kAllQuadricKinds),
                         [](const auto& instance) { return nameOf(instance.param); });

} // namespace
} // namespace calotype::test
