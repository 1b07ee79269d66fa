// The reference tracer in scenes whose radiance is known.
#include <cmath>

#include <gtest/gtest.h>

#include "reference/reference_tracer.h"
#include "support/scene_builder.h"
#include "support/statistics.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

using reference::ReferenceTracer;

/// Mean radiance of all pixels' samples, first channel; every one of them is finite.
Estimate radianceOf(const Scene& scene, uint32_t samples) {
    const glm::uvec2 size(scene.film.width, scene.film.height);
    const ReferenceTracer tracer(scene, size, scene.render.maxBounces);
    std::vector<double> values;
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x)
            for (uint32_t i = 0; i < samples; ++i) {
                const double radiance = tracer.trace({{x, y}, i, 7}).radiance.x;
                EXPECT_TRUE(std::isfinite(radiance));
                values.push_back(radiance);
            }
    return estimate(values);
}

void expectNear(const Estimate& seen, double expected) {
    EXPECT_NEAR(seen.mean, expected, 4.0 * seen.standardError + 1e-9 * expected);
    EXPECT_LT(seen.standardError, 0.01 * expected);
}

/// A closed wall that glows, seen from inside, along paths of at most `bounces` events.
Scene furnace(Shape wall, double albedo, uint32_t bounces) {
    SceneBuilder builder;
    wall.material = builder.material(albedo, 1.0);
    if (auto* mesh = std::get_if<Mesh>(&wall.geometry))
        for (Mesh::Triangle& triangle : mesh->triangles)
            triangle.material = wall.material;
    builder.add(std::move(wall));
    builder.scene().camera.position = {0.1, 0.2, 0.15};
    builder.scene().render.maxBounces = bounces;
    return builder.scene();
}

TEST(ReferenceTracerTest, SumsTheSeriesOfAFurnace) {
    for (const Shape& wall :
         {shapeOf(Sphere{{}, 1.0}), shapeOf(Cylinder{{}, 1.0, 2.0}), shapeOf(cubeMesh(2))})
        for (const uint32_t bounces : {0u, 1u, 4u, 30u}) {
            SCOPED_TRACE(bounces);
            const double expected = (1.0 - std::pow(0.6, bounces + 1)) / 0.4;
            expectNear(radianceOf(furnace(wall, 0.6, bounces), 64), expected);
        }
}

/// A ball before the camera, about which light of radiance 1 comes from everywhere.
Scene ballInTheOpen(const Material& material) {
    SceneBuilder builder;
    builder.add(makeShape(Sphere{{}, 1.0}, builder.material(material)));
    Scene& scene = builder.scene();
    scene.background = glm::dvec3(1.0);
    scene.camera.position = {0.0, 0.0, 3.0};
    scene.camera.verticalFov = 0.4; // within the ball's outline
    scene.render.maxBounces = 64;
    return scene;
}

TEST(ReferenceTracerTest, GlassDisappearsInEvenLight) {
    for (const double ior : {1.0 / 1.5, 1.5}) {
        Material glass;
        glass.type = MaterialType::Dielectric;
        glass.color = glm::dvec3(1.0);
        glass.ior = ior;
        const Estimate seen = radianceOf(ballInTheOpen(glass), 64);
        EXPECT_NEAR(seen.mean, 1.0, 1e-3); // some paths are caught inside for more than 64 events
    }
}

TEST(ReferenceTracerTest, ConvexBodiesShowTheirAlbedo) {
    Material grey;
    grey.color = glm::dvec3(0.3);
    expectNear(radianceOf(ballInTheOpen(grey), 64), 0.3);
    Material white; // lets four of five rays through
    white.color = glm::dvec3(1.0);
    white.opacity = 0.2;
    expectNear(radianceOf(ballInTheOpen(white), 64), 1.0);
}

} // namespace
} // namespace calotype::test
