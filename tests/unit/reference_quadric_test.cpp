#include <gtest/gtest.h>

#include "unit/reference_shapes.h"

// Every hit is known before the ray: a point of the surface is chosen and the ray derived from it.
// The solids are convex, so a line that enters through a point has met nothing before, and from
// every point inside every point of the surface is seen.

namespace calotype::test {
namespace {

using reference::Geometry;
using reference::Ray;
using reference::Surface;

/// How far a hit may be off, relative to the coordinates and the distance that it was found from:
/// placing the point and the ray takes some ten roundings of 2^-53, and so does finding it. Divided
/// by the cosine of incidence where the ray is what is off.
constexpr double kRoundings = 64.0 * 0x1p-53;

struct Placement {
    std::string name;
    double size;
    double distance; ///< from the world's origin, in sizes
};

using Parameter = std::tuple<QuadricKind, Placement>;

class ReferenceQuadricTest : public testing::TestWithParam<Parameter> {
protected:
    static constexpr int kShapes = 200;
    static constexpr int kRaysEach = 50;

    /// Calls check(geometry, surface point, size, random) for many points of many shapes.
    template <typename Check>
    void forManyPoints(const Check& check) {
        const auto& [kind, placement] = GetParam();
        RandomNumbers random(7);
        for (int i = 0; i < kShapes; ++i) {
            const glm::dvec3 center = placement.size * placement.distance * random.direction();
            const Scene scene = sceneOf({randomQuadric(kind, center, placement.size, random)});
            const Geometry geometry(scene);
            for (int k = 0; k < kRaysEach; ++k) {
                const SurfacePoint point = pointOf(scene.shapes[0], random);
                check(geometry, point, placement.size, random);
                if (HasFatalFailure())
                    return;
            }
        }
    }

    static void expectHit(const Geometry& geometry, const Ray& ray, const SurfacePoint& point) {
        const auto hit = geometry.closest(ray);
        ASSERT_TRUE(hit);
        const double distance = glm::distance(ray.origin, point.position);
        const double cosine = std::abs(glm::dot(ray.direction, point.normal));
        const double tolerance =
            kRoundings * (magnitude(ray.origin) + magnitude(point.position) + distance) / cosine;
        ASSERT_NEAR(hit->t, distance, tolerance);
        const Surface surface = geometry.surface(*hit, ray);
        ASSERT_LT(glm::distance(surface.position, point.position), tolerance);
        ASSERT_LT(glm::distance(surface.ng, point.normal), tolerance / point.radius + kRoundings);
        ASSERT_EQ(surface.ns, surface.ng);
        ASSERT_EQ(surface.horizon, surface.ng);
        ASSERT_EQ(surface.toSmooth, glm::dvec3(0.0));
    }
};

TEST_P(ReferenceQuadricTest, IsEnteredWhereARayIsAimed) {
    forManyPoints([](const Geometry& geometry, const SurfacePoint& point, double size,
                     RandomNumbers& random) {
        const glm::dvec3 direction = -directionAbove(point.normal, random);
        const double distance = size * random.powerOfTen(-2.0, 4.0);
        expectHit(geometry, {point.position - distance * direction, direction}, point);
    });
}

TEST_P(ReferenceQuadricTest, IsLeftWhereARayFromInsideIsAimed) {
    forManyPoints([](const Geometry& geometry, const SurfacePoint& point, double, RandomNumbers&) {
        const glm::dvec3 direction = glm::normalize(point.position - point.pointInside);
        if (glm::dot(direction, point.normal) > 1e-3)
            expectHit(geometry, {point.pointInside, direction}, point);
    });
}

TEST_P(ReferenceQuadricTest, IsNotMetByWhatMovesAway) {
    forManyPoints([](const Geometry& geometry, const SurfacePoint& point, double size,
                     RandomNumbers& random) {
        const glm::dvec3 direction = directionAbove(point.normal, random);
        const double distance = size * random.powerOfTen(-2.0, 4.0);
        ASSERT_FALSE(geometry.closest({point.position + distance * direction, direction}));
    });
}

// A line along a tangent plane, a little way off, passes the whole convex solid: its own roundings
// and what counts as on the surface are 64 of 2^-53 each.
TEST_P(ReferenceQuadricTest, IsPassedAlongItsTangents) {
    forManyPoints([](const Geometry& geometry, const SurfacePoint& point, double size,
                     RandomNumbers& random) {
        const glm::dvec3 tangent = glm::normalize(glm::cross(point.normal, random.direction()));
        const double distance = size * random.powerOfTen(-1.0, 2.0);
        const double rounding = 2.0 * kRoundings * (magnitude(point.position) + distance);
        const glm::dvec3 origin = point.position +
                                  rounding * random.powerOfTen(0.0, 6.0) * point.normal -
                                  distance * tangent;
        ASSERT_FALSE(geometry.closest({origin, tangent}));
    });
}

TEST_P(ReferenceQuadricTest, EndsTheRayAtItsLength) {
    forManyPoints([](const Geometry& geometry, const SurfacePoint& point, double size,
                     RandomNumbers& random) {
        const glm::dvec3 direction = -directionAbove(point.normal, random);
        const Ray ray{point.position - size * direction, direction};
        const auto hit = geometry.closest(ray);
        ASSERT_TRUE(hit);
        ASSERT_FALSE(geometry.closest({ray.origin, direction, hit->t}));
        ASSERT_TRUE(geometry.closest({ray.origin, direction, std::nextafter(hit->t, 1e300)}));
    });
}

INSTANTIATE_TEST_SUITE_P(Of, ReferenceQuadricTest,
                         testing::Combine(testing::ValuesIn(kQuadricKinds),
                                          testing::Values(Placement{"AtHome", 1.0, 0.0},
                                                          Placement{"Near", 1.0, 3.0},
                                                          Placement{"Moved", 1.0, 1e6},
                                                          Placement{"TinyMoved", 1e-6, 1e6},
                                                          Placement{"Huge", 1e6, 1.0})),
                         [](const auto& instance) {
                             return nameOf(std::get<0>(instance.param)) +
                                    std::get<1>(instance.param).name;
                         });

/// The first hit of a ray from `origin` with a shape in the world's frame, or infinity.
double distanceTo(const Shape& shape, const glm::dvec3& origin, const glm::dvec3& direction) {
    const Scene scene = sceneOf({shape});
    const auto hit = Geometry(scene).closest({origin, glm::normalize(direction)});
    return hit ? hit->t : std::numeric_limits<double>::infinity();
}

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(ReferenceConeTest, MeetsRaysParallelToItsSide) {
    // Slope 3/4, so (3, 4, 0) / 5 runs along a line of the side.
    const Shape cone = shapeOf(Cone{{}, 4.0, 0.75});
    // In the plane of that line and its opposite, (x, y) from (-5, 0): meets x = -3/4 y.
    EXPECT_NEAR(distanceTo(cone, {-5.0, 0.0, 0.0}, {3.0, 4.0, 0.0}), 25.0 / 6.0, 1e-14);
    EXPECT_EQ(distanceTo(cone, {5.0, 0.0, 0.0}, {3.0, 4.0, 0.0}), kNever);
    // From inside, it leaves through the base.
    EXPECT_NEAR(distanceTo(cone, {0.0, 2.0, 0.0}, {3.0, 4.0, 0.0}), 2.5, 1e-14);
    EXPECT_NEAR(distanceTo(cone, {0.0, 2.0, 0.0}, {-3.0, -4.0, 0.0}), 5.0 / 4.0, 1e-14);
}

TEST(ReferenceConeTest, IsMetAtItsApexAndHasNoMirrorImage) {
    for (const double sign : {1.0, -1.0}) {
        const Shape cone = shapeOf(Cone{{}, sign * 2.0, 1.0});
        EXPECT_NEAR(distanceTo(cone, {0.0, -sign * 3.0, 0.0}, {0.0, sign, 0.0}), 3.0, 1e-14);
        EXPECT_NEAR(distanceTo(cone, {-0.3, -sign * 3.0, 0.0}, {0.1, sign, 0.0}),
                    3.0 * std::hypot(0.1, 1.0), 1e-14);
        EXPECT_EQ(distanceTo(cone, {-5.0, -sign * 1.0, 0.0}, {1.0, 0.0, 0.0}), kNever);
        EXPECT_EQ(distanceTo(cone, {0.0, -sign * 1.0, 0.0}, {0.0, -sign, 0.0}), kNever);
        EXPECT_NEAR(distanceTo(cone, {0.0, sign * 5.0, 0.0}, {0.0, -sign, 0.0}), 3.0, 1e-14);
    }
}

TEST(ReferenceConeTest, IsEnteredByEverySteepRayThroughItsApex) {
    RandomNumbers random(4);
    for (int i = 0; i < 10000; ++i) {
        const double slope = random.powerOfTen(-2.0, 2.0);
        const Shape cone = shapeOf(Cone{{someRotation(random), {}}, 1.0, slope});
        const double phi = 2.0 * std::numbers::pi * random.unit();
        const double lean = 0.9 * slope * random.unit();
        const glm::dvec3 direction = frameOf(cone).direction(
            glm::normalize(glm::dvec3(lean * std::cos(phi), 1.0, lean * std::sin(phi))));
        const double distance = random.powerOfTen(-3.0, 3.0);
        // The apex is missed by some roundings of the distance; the side is met that much later,
        // over the angle to it, at least a twentieth of the lesser of slope and its inverse.
        const double tolerance = kRoundings * distance * 20.0 * std::max(slope, 1.0 / slope);
        ASSERT_NEAR(distanceTo(cone, -distance * direction, direction), distance, tolerance);
        // From the apex itself, to the base or away. The direction's part along the axis, 1 /
        // toBase, is rounded as coarsely as its length, 1.
        const double toBase = std::hypot(1.0, lean);
        ASSERT_NEAR(distanceTo(cone, {}, direction), toBase, kRoundings * toBase * toBase);
        ASSERT_EQ(distanceTo(cone, {}, -direction), kNever);
    }
}

TEST(ReferenceConeTest, FarAwayKeepsRaysAlongItsSideExact) {
    // From a million sizes away, in the direction of a line of the side but for a little.
    RandomNumbers random(3);
    const Shape cone = shapeOf(Cone{{}, 4.0, 0.75});
    const Scene scene = sceneOf({cone});
    const Geometry geometry(scene);
    for (int i = 0; i < 10000; ++i) {
        const glm::dvec3 along = glm::normalize(
            glm::dvec3(3.0, 4.0, 0.0) + random.powerOfTen(-12.0, -3.0) * random.direction());
        const SurfacePoint point = pointOf(cone, random);
        if (glm::dot(point.normal, along) > -0.01)
            continue;
        const double distance = random.powerOfTen(1.0, 6.0);
        const auto hit = geometry.closest({point.position - distance * along, along});
        ASSERT_TRUE(hit);
        ASSERT_NEAR(hit->t, distance, 100.0 * kRoundings * (distance + 10.0));
    }
}

TEST(ReferenceCylinderTest, MeetsRaysAlongItsAxisAtItsCaps) {
    const Shape cylinder = shapeOf(Cylinder{{}, 1.0, 2.0});
    EXPECT_EQ(distanceTo(cylinder, {0.5, 3.0, 0.0}, {0.0, -1.0, 0.0}), 2.0);
    EXPECT_EQ(distanceTo(cylinder, {0.5, 0.0, 0.0}, {0.0, -1.0, 0.0}), 1.0);
    EXPECT_EQ(distanceTo(cylinder, {1.5, 3.0, 0.0}, {0.0, -1.0, 0.0}), kNever);
    // Next to nothing across the axis.
    EXPECT_EQ(distanceTo(cylinder, {0.5, 3.0, 0.0}, {1e-200, -1.0, 0.0}), 2.0);
    EXPECT_EQ(distanceTo(cylinder, {1.5, 3.0, 0.0}, {1e-200, -1.0, 0.0}), kNever);
    EXPECT_EQ(distanceTo(cylinder, {1.5, 0.0, 0.0}, {-1.0, 0.0, 0.0}), 0.5);
}

TEST(ReferenceQuadricExtremesTest, OfProportionsFromAHundredThousandthToAHundredThousand) {
    RandomNumbers random(5);
    for (const double ratio : {1e-5, 1e5}) {
        for (const Shape& shape : {shapeOf(Cylinder{{someRotation(random), {}}, ratio, 1.0}),
                                   shapeOf(Cone{{someRotation(random), {}}, 1.0, ratio}),
                                   shapeOf(Cone{{someRotation(random), {}}, -ratio, 1.0})}) {
            const Scene scene = sceneOf({shape});
            const Geometry geometry(scene);
            const double size = std::max(ratio, 1.0);
            for (int i = 0; i < 20000; ++i) {
                const SurfacePoint point = pointOf(shape, random);
                const glm::dvec3 direction = -directionAbove(point.normal, random);
                const auto entry = geometry.closest({point.position - size * direction, direction});
                ASSERT_TRUE(entry);
                // Of the larger measure, not of the smaller.
                ASSERT_NEAR(entry->t, size, 100.0 * kRoundings * size);
                const glm::dvec3 outward = glm::normalize(point.position - point.pointInside);
                ASSERT_TRUE(geometry.closest({point.pointInside, outward}));
            }
        }
    }
}

} // namespace
} // namespace calotype::test
