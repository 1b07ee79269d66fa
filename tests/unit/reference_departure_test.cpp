#include <gtest/gtest.h>

#include "unit/reference_shapes.h"

// Rays that leave a surface, from where offsetFrom puts them: outward they never meet the
// convex shape again, inward they meet its far side and nothing before.

namespace calotype::test {
namespace {

using reference::Geometry;
using reference::offsetFrom;
using reference::Ray;
using reference::Surface;

/// The offset is 64 units of 2^-53, and finding both ends takes as many roundings again.
constexpr double kRoundings = 256.0 * 0x1p-53;

struct Place {
    std::string name;
    double size;
    double distance;       ///< from the world's origin, in sizes
    bool touchesTheOrigin; ///< of the world: coordinates near 0 on a large shape
};

Shape placeShape(QuadricKind kind, const Place& place, RandomNumbers& random) {
    const glm::dvec3 center = place.size * place.distance * random.direction();
    return randomQuadric(kind, center, place.size, random);
}

class ReferenceDepartureTest : public testing::TestWithParam<std::tuple<QuadricKind, Place>> {};

/// Moves the shape so that the point comes to lie at the world's origin.
void bringToOrigin(Shape& shape, SurfacePoint& point) {
    std::visit(
        [&]<typename Geometry>(Geometry& geometry) {
            if constexpr (!std::is_same_v<Geometry, Mesh>)
                geometry.worldFromObject.translation -= point.position;
        },
        shape.geometry);
    point.pointInside -= point.position;
    point.position = glm::dvec3(0.0);
}

TEST_P(ReferenceDepartureTest, MeetsTheFarSideOnly) {
    const auto& [kind, place] = GetParam();
    RandomNumbers random(11);
    uint32_t found = 0;
    for (int i = 0; i < 5000; ++i) {
        Shape shape = placeShape(kind, place, random);
        SurfacePoint point = pointOf(shape, random);
        if (place.touchesTheOrigin)
            bringToOrigin(shape, point);
        const Scene scene = sceneOf({shape});
        const Geometry geometry(scene);
        const glm::dvec3 arriving = -directionAbove(point.normal, random);
        const Ray ray{point.position - place.size * arriving, arriving};
        const auto hit = geometry.closest(ray);
        ASSERT_TRUE(hit);
        const Surface surface = geometry.surface(*hit, ray);
        const double side = random.sign();
        const glm::dvec3 normal = side * surface.ng;
        const glm::dvec3 origin = offsetFrom(surface.position, normal);
        const Ray leaving{origin, directionAbove(normal, random, -6.0)};
        const auto next = geometry.closest(leaving);
        if (side > 0.0 || kind == QuadricKind::Disk) {
            ASSERT_FALSE(next) << "met itself at " << next->t;
            continue;
        }
        ASSERT_TRUE(next) << "escaped";
        ++found;
        // The way between is inside: seen from its middle, both ends are as far.
        const double half = 0.5 * next->t;
        const glm::dvec3 middle = origin + half * leaving.direction;
        const auto forward = geometry.closest({middle, leaving.direction});
        const auto back = geometry.closest({middle, -leaving.direction});
        ASSERT_TRUE(forward && back);
        const double cosineHere = glm::dot(leaving.direction, normal);
        const double cosineThere = glm::dot(leaving.direction, geometry.surface(*next, leaving).ng);
        const double tolerance =
            kRoundings * (magnitude(origin) + 2.0 * place.size) / std::min(cosineHere, cosineThere);
        ASSERT_NEAR(forward->t, half, tolerance);
        ASSERT_NEAR(back->t, half, tolerance);
    }
    EXPECT_TRUE(found > 2000 || kind == QuadricKind::Disk) << found;
}

INSTANTIATE_TEST_SUITE_P(Of, ReferenceDepartureTest,
                         testing::Combine(testing::ValuesIn(kQuadricKinds),
                                          testing::Values(Place{"AtHome", 1.0, 0.0, false},
                                                          Place{"Tiny", 1e-6, 3.0, false},
                                                          Place{"Huge", 1e6, 3.0, false},
                                                          Place{"HugeAtOrigin", 1e6, 0.0, true},
                                                          Place{"Moved", 1.0, 1e6, false})),
                         [](const auto& instance) {
                             return nameOf(std::get<0>(instance.param)) +
                                    std::get<1>(instance.param).name;
                         });

} // namespace
} // namespace calotype::test
