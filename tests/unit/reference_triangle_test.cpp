#include <gtest/gtest.h>

#include "unit/reference_shapes.h"

// Triangles are hit where their weights say, and closed meshes let no ray pass.

namespace calotype::test {
namespace {

using reference::Geometry;
using reference::Ray;
using reference::Surface;

/// As in reference_quadric_test.cpp.
constexpr double kRoundings = 64.0 * 0x1p-53;

struct RandomTriangle {
    glm::dvec3 corners[3];

    RandomTriangle(const glm::dvec3& center, double size, RandomNumbers& random) {
        for (glm::dvec3& corner : corners)
            corner = center + size * random.direction();
    }

    glm::dvec3 at(double w1, double w2) const {
        return (1.0 - w1 - w2) * corners[0] + w1 * corners[1] + w2 * corners[2];
    }
    glm::dvec3 areaVector() const {
        return 0.5 * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    }
    Shape shape() const { return shapeOf(singleTriangle(corners[0], corners[1], corners[2])); }
};

struct Placement {
    std::string name;
    double size;
    double distance; ///< from the world's origin, in sizes
};

class ReferenceTriangleTest : public testing::TestWithParam<Placement> {};

TEST_P(ReferenceTriangleTest, IsHitFromBothSidesWithinItsEdgesOnly) {
    const auto& [name, size, distance] = GetParam();
    RandomNumbers random(21);
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 center = size * distance * random.direction();
        const RandomTriangle triangle(center, size, random);
        const double area = glm::length(triangle.areaVector());
        if (area < 0.1 * size * size) // less than a tenth of a radian at any corner
            continue;
        const Scene scene = sceneOf({triangle.shape()});
        const Geometry geometry(scene);
        EXPECT_NEAR(geometry.areaOf(0), area, kRoundings * (1.0 + distance) * size * size);

        const glm::dvec3 normal = triangle.areaVector() / area;
        const glm::dvec3 direction = directionAbove(random.sign() * normal, random);
        const double t = size * random.powerOfTen(-2.0, 3.0);
        const double cosine = std::abs(glm::dot(direction, normal));
        const double tolerance = 4.0 * kRoundings * (magnitude(center) + 2.0 * t + size) / cosine;
        double w1 = random.unit();
        double w2 = random.unit();
        if (w1 + w2 > 1.0) {
            w1 = 1.0 - w1;
            w2 = 1.0 - w2;
        }
        const glm::dvec3 target = triangle.at(w1, w2);
        const double inside = std::min({w1, w2, 1.0 - w1 - w2});
        if (inside * size > 10.0 * tolerance) {
            const Ray ray{target - t * direction, direction};
            const auto hit = geometry.closest(ray);
            ASSERT_TRUE(hit);
            ASSERT_NEAR(hit->t, t, tolerance);
            const Surface surface = geometry.surface(*hit, ray);
            ASSERT_LT(glm::distance(surface.position, target), tolerance);
            ASSERT_LT(glm::distance(surface.ng, normal), 10.0 * kRoundings * (1.0 + distance));
            ASSERT_FALSE(geometry.closest({target + t * direction, direction}));
            const double side = random.sign();
            const glm::dvec3 leaving = directionAbove(side * surface.ng, random, -6.0);
            ASSERT_FALSE(geometry.closest(
                {reference::offsetFrom(surface.position, side * surface.ng), leaving}));
        }
        // As near to the edge from outside: the first corner's weight is negative.
        const double beyond = 20.0 * tolerance / size;
        const double along = random.unit();
        const glm::dvec3 outside =
            triangle.at(along * (1.0 + beyond), (1.0 - along) * (1.0 + beyond));
        ASSERT_FALSE(geometry.closest({outside - t * direction, direction}));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, ReferenceTriangleTest,
                         testing::Values(Placement{"AtHome", 1.0, 1.0},
                                         Placement{"Tiny", 1e-6, 1.0}, Placement{"Huge", 1e6, 1.0},
                                         Placement{"Moved", 1.0, 1e6}),
                         [](const auto& instance) { return instance.param.name; });

TEST(ReferenceTriangleAtOriginTest, DoesNotMeetRaysThatLeaveItThoughItIsHuge) {
    // Offsets next to the world's origin are next to nothing, compared with the triangle.
    RandomNumbers random(22);
    for (int i = 0; i < 5000; ++i) {
        RandomTriangle triangle({}, 1e6, random);
        const glm::dvec3 middle = triangle.at(0.3, 0.3);
        for (glm::dvec3& corner : triangle.corners)
            corner -= middle;
        const Scene scene = sceneOf({triangle.shape()});
        const Geometry geometry(scene);
        const glm::dvec3 normal = glm::normalize(triangle.areaVector());
        const glm::dvec3 arriving = directionAbove(-normal, random);
        const Ray ray{-1e3 * arriving, arriving};
        const auto hit = geometry.closest(ray);
        ASSERT_TRUE(hit);
        const Surface surface = geometry.surface(*hit, ray);
        const glm::dvec3 side = random.sign() * surface.ng;
        ASSERT_FALSE(geometry.closest(
            {reference::offsetFrom(surface.position, side), directionAbove(side, random, -6.0)}));
    }
}

/// A point of a random edge: a corner for every third ray.
glm::dvec3 edgePoint(const Mesh& mesh, RandomNumbers& random) {
    const auto& triangle = mesh.triangles[random.below(uint32_t(mesh.triangles.size()))];
    const uint32_t corner = random.below(3);
    const glm::dvec3 from = mesh.positions[triangle.position[corner]];
    const glm::dvec3 to = mesh.positions[triangle.position[(corner + 1) % 3]];
    return random.below(3) == 0 ? from : glm::mix(from, to, random.unit());
}

/// All corners by scale * p + shift.
Mesh moved(Mesh mesh, const glm::dvec3& scale, const glm::dvec3& shift) {
    for (glm::dvec3& position : mesh.positions)
        position = scale * position + shift;
    return mesh;
}

/// How many of `rays` rays escape: from inside the ellipsoid of those half axes about the centre,
/// aimed at corners and at points of edges.
uint32_t countEscapes(const Mesh& mesh, const glm::dvec3& center, const glm::dvec3& halfAxes,
                      uint32_t rays) {
    const Scene scene = sceneOf({shapeOf(mesh)});
    const Geometry geometry(scene);
    RandomNumbers random(23);
    uint32_t escapes = 0;
    for (uint32_t i = 0; i < rays; ++i) {
        const glm::dvec3 origin = center + halfAxes * random.inBall();
        const glm::dvec3 direction = glm::normalize(edgePoint(mesh, random) - origin);
        escapes += geometry.closest({origin, direction}) ? 0 : 1;
    }
    return escapes;
}

constexpr uint32_t kRays = 200'000;
constexpr glm::dvec3 kNear(0.9);

TEST(ReferenceClosedMeshTest, OfSharedCornersLetsNoRayOut) {
    EXPECT_EQ(countEscapes(icosphere(4, glm::dvec3(0.0), 1.0), {}, kNear, kRays), 0u);
}

TEST(ReferenceClosedMeshTest, WithFlatAxisAlignedBoxesLetsNoRayOut) {
    EXPECT_EQ(countEscapes(cubeMesh(16), {}, kNear, kRays), 0u);
}

TEST(ReferenceClosedMeshTest, MovedByAMillionSizesLetsNoRayOut) {
    const glm::dvec3 center(1e6, -3e5, 7e5);
    EXPECT_EQ(countEscapes(icosphere(4, center, 1.0), center, kNear, kRays), 0u);
}

TEST(ReferenceClosedMeshTest, OfSliversLetsNoRayOut) {
    const glm::dvec3 halfAxes(1.0, 1e-9, 1e-3);
    const Mesh flat = moved(icosphere(4, glm::dvec3(0.0), 1.0), halfAxes, glm::dvec3(0.0));
    EXPECT_EQ(countEscapes(flat, {}, 0.9 * halfAxes, kRays / 4), 0u);
}

// Double rounding leaves many products of coordinates equal here, so the exact sign is needed. In
// thinner ones a start inside counts as in the plane of the walls.
TEST(ReferenceClosedMeshTest, SeenAsANeedleLetsNoRayOut) {
    const glm::dvec3 halfAxes(1.0, 1e-13, 1e-13);
    const Mesh needle = moved(icosphere(3, glm::dvec3(0.0), 1.0), halfAxes, glm::dvec3(0.0));
    EXPECT_EQ(countEscapes(needle, {}, 0.5 * halfAxes, kRays / 10), 0u);
}

TEST(ReferenceClosedMeshTest, LetsNoAxisAlignedRayOutAlongItsEdges) {
    const Mesh cube = cubeMesh(32);
    const Scene scene = sceneOf({shapeOf(cube)});
    const Geometry geometry(scene);
    RandomNumbers random(24);
    uint32_t escapes = 0;
    for (uint32_t i = 0; i < kRays; ++i) {
        // The corners are multiples of 1/16, so the ray runs exactly at one, or along an edge.
        const auto onGrid = [&] { return (random.below(31) - 15.0) / 16.0; };
        const auto axis = static_cast<int>(random.below(3));
        glm::dvec3 origin(onGrid(), onGrid(), onGrid());
        origin[(axis + 1) % 3] = random.coin() ? origin[(axis + 1) % 3] : random.between(-0.9, 0.9);
        glm::dvec3 direction(random.coin() ? 0.0 : -0.0);
        direction[axis] = random.sign();
        if (random.coin()) // or tilted by next to nothing
            direction[(axis + 2) % 3] = random.sign() * random.powerOfTen(-200.0, -17.0);
        escapes += geometry.closest({origin, direction}) ? 0 : 1;
    }
    EXPECT_EQ(escapes, 0u);
}

TEST(ReferenceClosedMeshTest, LetsNoRayInFromAfar) {
    const Mesh mesh = icosphere(4, glm::dvec3(0.0), 1.0);
    const Scene scene = sceneOf({shapeOf(mesh)});
    const Geometry geometry(scene);
    RandomNumbers random(25);
    uint32_t entered = 0;
    for (uint32_t i = 0; i < kRays; ++i) {
        const glm::dvec3 target = edgePoint(mesh, random);
        const glm::dvec3 toOrigin = random.direction();
        if (glm::dot(toOrigin, target) < 0.2) // so all triangles about the target face the ray
            continue;
        const double distance = random.powerOfTen(0.0, 8.0);
        const Ray ray{target + distance * toOrigin, -toOrigin};
        const auto hit = geometry.closest(ray);
        ASSERT_TRUE(hit);
        entered += glm::dot(geometry.surface(*hit, ray).ng, toOrigin) > 0.0 ? 0 : 1;
    }
    EXPECT_EQ(entered, 0u);
}

} // namespace
} // namespace calotype::test
