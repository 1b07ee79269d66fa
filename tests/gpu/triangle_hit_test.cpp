#include "pack/pack_shapes.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/oracle_triangle.h"
#include "support/primitive_scene.h"
#include "support/test_quadrics.h"

// Single triangles against the oracle. The corners as seen along the ray carry about 6 roundings
// relative to their distance M from the origin, two of them make an edge: so a hit may be missed or
// invented only within 16 2^-23 M of an edge. t follows from the corners' depths with weights that
// are off by the same, magnified where the triangle is a needle or seen edge on.

namespace calotype::test {
namespace {

constexpr Real kAllowedRoundoffs = 16.0L;

struct TriangleCase {
    shared::Triangle triangle;
    glm::dvec3 origin;
    glm::dvec3 direction;
};

glm::dvec3 pointOn(const shared::Triangle& triangle, RandomNumbers& random) {
    double b1 = random.unit();
    double b2 = random.unit();
    const uint32_t where = random.below(4);
    if (b1 + b2 > 1.0 && where < 2) {
        b1 = 1.0 - b1;
        b2 = 1.0 - b2;
    }
    if (where == 2) // on an edge
        b2 = random.coin() ? 0.0 : 1.0 - b1;
    if (where == 3) // at a corner
        b1 = b2 = 0.0;
    const glm::dvec3 v0(triangle.v0);
    return v0 + b1 * (glm::dvec3(triangle.v1) - v0) + b2 * (glm::dvec3(triangle.v2) - v0);
}

/// A triangle about the point `center`, of the given size and thinness.
shared::Triangle randomTriangle(const glm::dvec3& center, double size, double thinness,
                                RandomNumbers& random) {
    const glm::dvec3 along = size * random.direction();
    const glm::dvec3 across = glm::normalize(glm::cross(along, random.direction()));
    const glm::vec3 v0 = glm::vec3(center - random.unit() * along);
    const glm::vec3 v1(glm::dvec3(v0) + along);
    const glm::vec3 v2(glm::dvec3(v0) + random.unit() * along + size * thinness * across);
    return packTriangle(v0, v1, v2);
}

TriangleCase makeCase(double relativeSize, double thinness, RandomNumbers& random) {
    const double scale = random.powerOfTen(-3.0, 3.0);
    TriangleCase test;
    test.origin = glm::vec3(scale * random.inBall());
    const glm::dvec3 center = test.origin + scale * random.direction();
    test.triangle = randomTriangle(center, scale * relativeSize, thinness, random);
    const glm::vec3 target(pointOn(test.triangle, random));
    test.direction = target - glm::vec3(test.origin);
    if (random.coin())
        test.direction *= random.powerOfTen(-3.0, 3.0);
    return test;
}

struct TriangleErrors {
    Real distance = 0.0L;      ///< |t - exact| |d| in units of 2^-23 reach magnification
    Real positionShare = 0.0L; ///< distance from the plane, as a share of the stated error
    uint32_t missed = 0;
    uint32_t invented = 0;
    uint32_t disagreements = 0; ///< within the bound
};

void check(const TriangleCase& test, const shared::TestHit& hit, TriangleErrors& errors) {
    const Line line{Vec3(glm::vec3(test.origin)), Vec3(glm::vec3(test.direction))};
    const TriangleCrossing exact = crossTriangle(test.triangle, line);
    const Real margin = kAllowedRoundoffs * kRoundoff * exact.reach;
    const Real length = glm::length(line.direction);
    const bool isHit = hit.t < kFar;
    const bool near = exact.t * length < 8.0L * margin * exact.magnification;
    errors.missed += exact.insideBy > margin && !near && !isHit ? 1 : 0;
    errors.invented += exact.insideBy < -margin && isHit ? 1 : 0;
    errors.disagreements += (exact.insideBy >= 0.0L) != isHit ? 1 : 0;
    if (!isHit || std::abs(exact.insideBy) < margin)
        return;
    errors.distance =
        std::max(errors.distance, std::abs(hit.t - exact.t) * length /
                                      (kRoundoff * exact.reach * exact.magnification));
    const Vec3 v0(test.triangle.v0);
    const Vec3 normal =
        glm::normalize(glm::cross(Vec3(test.triangle.v1) - v0, Vec3(test.triangle.v2) - v0));
    const Real offPlane = std::abs(glm::dot(Vec3(hit.position) - v0, normal));
    errors.positionShare = std::max(errors.positionShare, offPlane / hit.error);
}

struct Sizes {
    const char* name;
    double sizePowers[2];     ///< size relative to the distance
    double thinnessPowers[2]; ///< height over base
};

class TriangleHitsTest : public GpuTest, public testing::WithParamInterface<Sizes> {};

TEST_P(TriangleHitsTest, AreExactWithinRounding) {
    constexpr uint32_t kCases = 100'000;
    RandomNumbers random(7);
    std::vector<TriangleCase> cases;
    std::vector<shared::Triangle> triangles;
    std::vector<shared::TestRay> rays;
    for (uint32_t i = 0; i < kCases; ++i) {
        const Sizes& sizes = GetParam();
        cases.push_back(
            makeCase(random.powerOfTen(sizes.sizePowers[0], sizes.sizePowers[1]),
                     random.powerOfTen(sizes.thinnessPowers[0], sizes.thinnessPowers[1]), random));
        triangles.push_back(cases.back().triangle);
        rays.push_back(testRay(cases.back().origin, cases.back().direction, i));
    }
    const auto hits = PrimitiveScene::ofTriangles(triangles).hits(rays);
    TriangleErrors errors;
    for (uint32_t i = 0; i < kCases; ++i)
        check(cases[i], hits[i], errors);
    RecordProperty("distanceRoundoffs", std::to_string(errors.distance));
    RecordProperty("positionShare", std::to_string(errors.positionShare));
    RecordProperty("disagreements", std::to_string(errors.disagreements));
    RecordProperty("missed", std::to_string(errors.missed));
    EXPECT_EQ(errors.missed, 0u);
    EXPECT_EQ(errors.invented, 0u);
    EXPECT_LE(errors.distance, kAllowedRoundoffs);
    EXPECT_LE(errors.positionShare, 1.0L);
}

INSTANTIATE_TEST_SUITE_P(Of, TriangleHitsTest,
                         testing::Values(Sizes{"UsualSize", {-1.0, 0.5}, {-0.5, 0.0}},
                                         Sizes{"SmallSize", {-4.0, -1.0}, {-0.5, 0.0}},
                                         Sizes{"MillionthSize", {-6.0, -4.0}, {-0.5, 0.0}},
                                         Sizes{"HugeSize", {0.5, 3.0}, {-0.5, 0.0}},
                                         Sizes{"NeedleShape", {-1.0, 0.5}, {-5.0, -2.0}}),
                         [](const auto& instance) { return instance.param.name; });

class TriangleBarycentricsTest : public GpuTest {};

// Such a projection has no area. The point of the longest edge that is nearest to the ray has
// weights of that edge's two corners, whichever two of the three these are.
TEST_F(TriangleBarycentricsTest, OfTrianglesSeenEdgeOnAreThoseOfTheLongestEdge) {
    const glm::vec3 corners[] = {{0, -1, 5}, {0, 3, 5}, {0, 0.5f, 6}}; // in the plane of the ray
    const double weights[] = {0.75, 0.25, 0.0}; // of y = 0 on the edge from y = -1 to y = 3
    std::vector<glm::uvec3> orders;
    std::vector<shared::Triangle> triangles;
    std::vector<shared::TestRay> rays;
    for (glm::uvec3 order : {glm::uvec3(0, 1, 2), glm::uvec3(1, 2, 0), glm::uvec3(2, 0, 1),
                             glm::uvec3(0, 2, 1), glm::uvec3(2, 1, 0), glm::uvec3(1, 0, 2)}) {
        orders.push_back(order);
        triangles.push_back(packTriangle(corners[order.x], corners[order.y], corners[order.z]));
        rays.push_back(testRay({0, 0, 0}, {0, 0, 1}, static_cast<uint32_t>(rays.size())));
    }
    const auto hits = PrimitiveScene::ofTriangles(triangles).hits(rays);
    for (size_t i = 0; i < hits.size(); ++i) {
        EXPECT_NEAR(hits[i].barycentric1, weights[orders[i].y], 1e-6) << "order " << i;
        EXPECT_NEAR(hits[i].barycentric2, weights[orders[i].z], 1e-6) << "order " << i;
    }
}

} // namespace
} // namespace calotype::test
