// Closed rooms that emit and reflect alike everywhere: the radiance is emission / (1 - albedo),
// from wherever one looks.
#include <cmath>

#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

class FurnaceTest : public GpuTest {};

void expectRadianceOne(const Scene& scene, double tolerance) {
    const RenderedScene result = renderScene(scene);
    const glm::dvec3 mean = imageMean(result.image);
    EXPECT_NEAR(mean.x, 1.0, tolerance);
    EXPECT_NEAR(mean.y, 1.0, tolerance);
    EXPECT_NEAR(mean.z, 1.0, tolerance);
    EXPECT_EQ(result.totals.losses.nonFiniteSamples, 0u);
    EXPECT_EQ(result.totals.losses.cutPaths, 0u);
    // No leak and no bright seam either: every pixel is near one.
    for (const glm::vec3& pixel : result.image.pixels)
        EXPECT_NEAR(pixel.x, 1.0, 0.25);
}

// Light of up to 20 events: what is missing is 0.5^21 of the whole.
Scene furnace(Shape enclosure) {
    SceneBuilder builder;
    builder.material(0.5, 0.5);
    builder.add(std::move(enclosure));
    Scene& scene = builder.scene();
    scene.film = {32, 32};
    scene.render = {256, 20, 1};
    scene.camera.position = {0.1, 0.2, 0.15};
    scene.camera.verticalFov = 1.5;
    return scene;
}

// The sphere is seen and sampled from inside: the bound, |mean - 1| < 0.002.
TEST_F(FurnaceTest, SphereOfTheScenesFolder) {
    Scene scene = projectScene("scenes/furnace.json");
    scene.render.samplesPerPixel = 128;
    expectRadianceOne(scene, 0.002);
}

TEST_F(FurnaceTest, Sphere) { expectRadianceOne(furnace(makeShape(Sphere{{}, 1.0}, 0)), 0.002); }

TEST_F(FurnaceTest, SphereFarFromTheOrigin) {
    Scene scene = furnace(makeShape(Sphere{{glm::dmat3(1.0), {1e4, -2e4, 3e4}}, 1.0}, 0));
    scene.camera.position += glm::dvec3(1e4, -2e4, 3e4);
    expectRadianceOne(scene, 0.002);
}

TEST_F(FurnaceTest, Cylinder) {
    expectRadianceOne(furnace(makeShape(Cylinder{{}, 0.7, 1.5}, 0)), 0.002);
}

TEST_F(FurnaceTest, Cone) {
    Cone cone{{glm::dmat3(1.0), {0.0, 1.0, 0.0}}, -2.0, 0.8};
    expectRadianceOne(furnace(makeShape(cone, 0)), 0.002);
}

TEST_F(FurnaceTest, BoxOfTriangles) {
    SceneBuilder builder;
    const uint32_t material = builder.material(0.5, 0.5);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            std::vector<glm::dvec3> corners;
            for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
                glm::dvec3 corner;
                corner[axis] = side;
                corner[(axis + 1) % 3] = u;
                corner[(axis + 2) % 3] = v;
                corners.push_back(corner);
            }
            builder.polygon(corners, material);
        }
    Scene& scene = builder.scene();
    scene.film = {32, 32};
    scene.render = {256, 20, 1};
    scene.camera.position = {0.1, 0.2, 0.15};
    scene.camera.verticalFov = 1.5;
    expectRadianceOne(scene, 0.002);
}

// Without reflection the same room shows its emission exactly, in each pixel and sample.
TEST_F(FurnaceTest, BlackSphereShowsItsEmissionExactly) {
    Scene scene = furnace(makeShape(Sphere{{}, 1.0}, 0));
    scene.materials[0].color = glm::dvec3(0.0);
    scene.materials[0].emission = glm::dvec3(0.25, 0.5, 2.0);
    scene.render.samplesPerPixel = 16;
    for (const glm::vec3& pixel : renderScene(scene).image.pixels)
        EXPECT_EQ(pixel, glm::vec3(0.25f, 0.5f, 2.0f));
}

// n scattering events give emission * (1 + a + ... + a^n).
TEST_F(FurnaceTest, MaxBouncesCountsScatteringEvents) {
    Scene scene = furnace(makeShape(Sphere{{}, 1.0}, 0));
    for (const uint32_t maxBounces : {0u, 1u, 2u, 4u}) {
        scene.render.maxBounces = maxBounces;
        const double expected = 1.0 - std::pow(0.5, maxBounces + 1);
        EXPECT_NEAR(imageMean(renderScene(scene).image).x, expected, 0.002) << maxBounces;
    }
}

} // namespace
} // namespace calotype::test
