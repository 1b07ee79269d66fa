#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "accel/primitive.h"
#include "pack/pack_shapes.h"
#include "support/test_quadrics.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

bool holds(const Bounds3f& bounds, const glm::dvec3& p) {
    const glm::dvec3 lower(bounds.lower);
    const glm::dvec3 upper(bounds.upper);
    return glm::max(lower, p) == p && glm::min(upper, p) == p;
}

/// A random shape of the given kind, rotated, up to 1000 sizes from the origin.
Shape randomQuadric(uint32_t kind, RandomNumbers& random) {
    const double size = random.powerOfTen(-3.0, 3.0);
    const RigidTransform frame{randomRotation(random),
                               random.direction() * size * random.powerOfTen(-1.0, 3.0)};
    const double proportion = random.powerOfTen(-1.5, 1.5);
    if (kind == shared::kSphere)
        return shapeOf(Sphere{frame, size});
    if (kind == shared::kCylinder)
        return shapeOf(Cylinder{frame, size, size * proportion});
    if (kind == shared::kCone)
        return shapeOf(Cone{frame, random.sign() * size, proportion});
    return shapeOf(Disk{frame, size});
}

/// The point of the packed surface that lies farthest along the unit vector w.
glm::dvec3 farthestPoint(const shared::Quadric& quadric, const glm::dvec3& w) {
    const glm::dvec3 center(quadric.center);
    const glm::dvec3 axis(quadric.axisY);
    const double along = glm::dot(w, axis);
    if (quadric.kind == shared::kSphere)
        return center + double{quadric.radius} * w;
    const glm::dvec3 rim = double{quadric.radius} * glm::normalize(w - along * axis);
    if (quadric.kind == shared::kCylinder)
        return center + std::copysign(0.5 * quadric.extent, along) * axis + rim;
    if (quadric.kind == shared::kDisk)
        return center + rim;
    const glm::dvec3 fromApex = double{quadric.extent} * axis + rim;
    return glm::dot(w, fromApex) > 0.0 ? center + fromApex : center;
}

class QuadricBoundsTest : public testing::TestWithParam<uint32_t> {};

TEST_P(QuadricBoundsTest, HoldThePackedSurfaceAndLittleMore) {
    RandomNumbers random(61 + GetParam());
    for (int i = 0; i < 300; ++i) {
        const Scene scene = sceneOf({randomQuadric(GetParam(), random)});
        const glm::dvec3 origin = i % 2 ? packingOrigin(scene) : glm::dvec3(0.0);
        const Bounds3f bounds = collectPrimitives(scene, origin)[0].bounds;
        const shared::Quadric packed = packQuadric(scene.shapes[0], origin, 0);
        Bounds3d sampled;
        for (int k = 0; k < 1000; ++k) {
            const glm::dvec3 p = worldPoint(packed, randomSurfacePoint(packed, random).position);
            ASSERT_TRUE(holds(bounds, p) && holds(bounds, glm::dvec3(glm::vec3(p))));
            sampled.extend(p);
        }
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                glm::dvec3 w(0.0);
                w[axis] = sign;
                const glm::dvec3 p = farthestPoint(packed, w);
                ASSERT_TRUE(holds(bounds, p) && holds(bounds, glm::dvec3(glm::vec3(p))));
            }
        // 1000 random points come near to each side of the tightest box.
        const glm::dvec3 slack = 0.35 * sampled.extent() +
                                 2e-5 * (glm::abs(sampled.lower) + glm::abs(sampled.upper)) +
                                 2e-5 * glm::length(sampled.extent());
        EXPECT_TRUE(glm::greaterThan(glm::dvec3(bounds.lower), sampled.lower - slack) ==
                    glm::bvec3(true));
        EXPECT_TRUE(glm::lessThan(glm::dvec3(bounds.upper), sampled.upper + slack) ==
                    glm::bvec3(true));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, QuadricBoundsTest, testing::ValuesIn(kAllQuadricKinds),
                         [](const auto& instance) { return nameOf(instance.param); });

TEST(PrimitivesTest, ComeInTheOrderOfTheScene) {
    const Scene scene =
        sceneOf({shapeOf(Sphere{}), shapeOf(icosphere(0, glm::dvec3(0.0), 1.0)), shapeOf(Disk{})});
    const std::vector<Primitive> primitives = collectPrimitives(scene, glm::dvec3(0.0));
    ASSERT_EQ(primitives.size(), 22u);
    EXPECT_EQ(primitives[0].kind, PrimitiveKind::Quadric);
    EXPECT_EQ(primitives[20].shape, 1u);
    EXPECT_EQ(primitives[20].triangle, 19u);
    EXPECT_EQ(primitives[20].kind, PrimitiveKind::Triangle);
    EXPECT_EQ(primitives[21].shape, 2u);
}

TEST(PrimitivesTest, OfTrianglesHaveTheTightestBoxOfTheirPackedCorners) {
    const glm::dvec3 origin(0.1, 0.2, 0.3);
    const Mesh mesh = singleTriangle({1.0 / 3.0, 5, -2}, {1, 0.7, 3}, {-1.1, 2, 0});
    const Bounds3f bounds = collectPrimitives(sceneOf({shapeOf(mesh)}), origin)[0].bounds;
    const shared::Triangle packed = packTriangle(mesh, 0, origin, 0);
    EXPECT_EQ(bounds.lower, glm::min(glm::min(packed.v0, packed.v1), packed.v2));
    EXPECT_EQ(bounds.upper, glm::max(glm::max(packed.v0, packed.v1), packed.v2));
}

TEST(PackingOriginTest, IsTheCameraWithinTheScene) {
    Scene scene = sceneOf({shapeOf(Sphere{{glm::dmat3(1.0), {10.0, 0.0, 0.0}}, 1.0})});
    scene.camera.position = {10.5, 0.25, 0.0};
    EXPECT_EQ(packingOrigin(scene), scene.camera.position);
    scene.camera.position = {1e6, -5.0, 0.5};
    EXPECT_EQ(packingOrigin(scene), glm::dvec3(11.0, -1.0, 0.5));
    scene.shapes.clear();
    EXPECT_EQ(packingOrigin(scene), scene.camera.position);
}

} // namespace
} // namespace calotype::test
