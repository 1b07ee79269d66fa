#include <gtest/gtest.h>

#include "unit/reference_shapes.h"

namespace calotype::test {
namespace {

using reference::Geometry;
using reference::Ray;

TEST(ReferenceGeometryTest, NumbersPrimitivesInTheOrderOfTheFile) {
    Mesh quad = cubeMesh(1);
    for (uint32_t i = 0; i < quad.triangles.size(); ++i)
        quad.triangles[i].material = 10 + i;
    const Scene scene = sceneOf({shapeOf(Sphere{}, 5), shapeOf(quad), shapeOf(Disk{}, 7)});
    const Geometry geometry(scene);
    ASSERT_EQ(geometry.primitiveCount(), 14u);
    EXPECT_EQ(geometry.primitive(0).shape, 0u);
    EXPECT_EQ(geometry.materialOf(0), 5u);
    for (uint32_t i = 0; i < 12; ++i) {
        EXPECT_EQ(geometry.primitive(1 + i).shape, 1u);
        EXPECT_EQ(geometry.primitive(1 + i).triangle, i);
        EXPECT_EQ(geometry.materialOf(1 + i), 10u + i);
    }
    EXPECT_EQ(geometry.primitive(13).shape, 2u);
    EXPECT_EQ(geometry.materialOf(13), 7u);
    // The sphere touches the cube from inside; from outside the cube is met first.
    const Ray ray{{0.5, 0.25, 3.0}, {0.0, 0.0, -1.0}};
    const auto hit = geometry.closest(ray);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 2.0);
    const reference::Surface surface = geometry.surface(*hit, ray);
    EXPECT_EQ(surface.primitive, hit->primitive);
    EXPECT_EQ(surface.material, 9u + hit->primitive);
    EXPECT_EQ(surface.ng, glm::dvec3(0, 0, 1));
}

TEST(ReferenceGeometryTest, OfAnEmptySceneIsNeverHit) {
    const Scene scene = sceneOf({});
    const Geometry geometry(scene);
    EXPECT_EQ(geometry.primitiveCount(), 0u);
    EXPECT_FALSE(geometry.closest({{0, 0, 0}, {0, 0, -1}}));
}

TEST(ReferenceGeometryTest, ComputesAreas) {
    constexpr double kPi = std::numbers::pi;
    const Scene scene =
        sceneOf({shapeOf(Sphere{{}, 2.0}), shapeOf(Cylinder{{}, 1.0, 2.0}),
                 shapeOf(Cone{{}, 4.0, 0.75}), shapeOf(Cone{{}, -4.0, 0.75}),
                 shapeOf(Disk{{}, 3.0}), shapeOf(singleTriangle({0, 0, 0}, {3, 0, 0}, {0, 0, 4}))});
    const Geometry geometry(scene);
    EXPECT_NEAR(geometry.areaOf(0), 16.0 * kPi, 1e-13);
    EXPECT_NEAR(geometry.areaOf(1), 6.0 * kPi, 1e-13);
    EXPECT_NEAR(geometry.areaOf(2), 24.0 * kPi, 1e-13); // radius 3, slant height 5
    EXPECT_NEAR(geometry.areaOf(3), 24.0 * kPi, 1e-13);
    EXPECT_NEAR(geometry.areaOf(4), 9.0 * kPi, 1e-13);
    EXPECT_NEAR(geometry.areaOf(5), 6.0, 1e-13);
}

/// The shape, scaled about the world's origin and then moved.
Shape transformed(Shape shape, double scale, const glm::dvec3& shift) {
    std::visit(
        [&]<typename Geometry>(Geometry& geometry) {
            if constexpr (std::is_same_v<Geometry, Mesh>) {
                for (glm::dvec3& position : geometry.positions)
                    position = scale * position + shift;
            } else {
                glm::dvec3& place = geometry.worldFromObject.translation;
                place = scale * place + shift;
            }
            if constexpr (requires { geometry.radius; })
                geometry.radius *= scale;
            if constexpr (requires { geometry.height; })
                geometry.height *= scale;
        },
        shape.geometry);
    return shape;
}

TEST(ReferenceGeometryTest, IsTheSameAtEveryScaleAndPlace) {
    RandomNumbers random(51);
    std::vector<Shape> shapes = {shapeOf(icosphere(2, {0.3, 0.2, 0.1}, 0.3))};
    for (int i = 0; i < 40; ++i)
        for (const QuadricKind kind : kQuadricKinds)
            shapes.push_back(randomQuadric(kind, random.inBall(), 0.1, random));
    const Scene scene = sceneOf(shapes);
    const Geometry geometry(scene);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const double distance : {0.0, 1e6}) {
            const glm::dvec3 shift = scale * distance * random.direction();
            std::vector<Shape> others;
            for (const Shape& shape : shapes)
                others.push_back(transformed(shape, scale, shift));
            const Scene otherScene = sceneOf(others);
            const Geometry other(otherScene);
            uint32_t differences = 0;
            for (int i = 0; i < 10000; ++i) {
                const Ray ray{1.5 * random.inBall(), random.direction()};
                const auto hit = geometry.closest(ray);
                const auto moved = other.closest({scale * ray.origin + shift, ray.direction});
                if (hit.has_value() != moved.has_value() ||
                    (hit && hit->primitive != moved->primitive)) {
                    ++differences;
                    continue;
                }
                // The places of origin and shape, rounded, and eight operations on them.
                const double rounding = 8.0 * 0x1p-53 * (2.0 + distance);
                if (hit) {
                    const double cosine =
                        std::abs(glm::dot(geometry.surface(*hit, ray).ng, ray.direction));
                    EXPECT_NEAR(moved->t / scale, hit->t, rounding / cosine);
                }
            }
            // Moved edges, off by 1e-10 of a size, decide for next to no ray.
            EXPECT_EQ(differences, 0u) << scale << " " << distance;
        }
    }
}

} // namespace
} // namespace calotype::test
