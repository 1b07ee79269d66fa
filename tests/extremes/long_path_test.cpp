// Paths of a thousand events, and rays that outgrow the device's loops.
#include <cmath>
#include <iostream>

#include <glm/geometric.hpp>

#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"
#include "support/statistics.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

class LongPathTest : public GpuTest {
protected:
    static bool hasLoopLimit() { return testDevice().info().type == "CPU"; }
};

constexpr double kAlbedo = 0.999;

/// A closed room that reflects nearly all, and glows so that endless paths would show 1.
Scene furnace(Shape enclosure, uint32_t maxBounces) {
    SceneBuilder builder;
    builder.material(kAlbedo, 1.0 - kAlbedo);
    builder.add(std::move(enclosure));
    Scene& scene = builder.scene();
    scene.camera.position = {0.1, 0.2, 0.15};
    scene.film = {16, 16};
    scene.render = {4, maxBounces, 0};
    return scene;
}

Shape boxOf(uint32_t squaresPerSide) {
    Shape box;
    box.geometry = cubeMesh(squaresPerSide);
    return box;
}

// After n events the sum has n + 1 terms: 1 - albedo^(n + 1).
TEST_F(LongPathTest, AThousandEventsInASphere) {
    const RenderedScene result = renderScene(furnace(makeShape(Sphere{{}, 1.0}, 0), 1000));
    EXPECT_EQ(result.totals.losses.cutPaths, 0u);
    EXPECT_EQ(result.totals.losses.nonFiniteSamples, 0u);
    EXPECT_EQ(result.totals.paths, 16u * 16u * 4u);
    const double expected = 1.0 - std::pow(kAlbedo, 1001);
    std::vector<double> pixels;
    for (const glm::vec3& pixel : result.image.pixels)
        pixels.push_back(pixel.x);
    const Estimate mean = estimate(pixels);
    // What a thousand products of albedo and direction's length leave: 2^-24 each, in the worst
    // case all to one side.
    EXPECT_NEAR(mean.mean, expected, 4.0 * mean.standardError + 1000 * 0x1p-24);
    std::cout << "relative difference " << mean.mean / expected - 1.0 << " +- "
              << mean.standardError / expected << "\n";
}

// In meshes of up to 19,200 triangles, whose rays take the most iterations.
TEST_F(LongPathTest, AThousandEventsInAMesh) {
    for (const uint32_t squares : {1u, 8u, 40u}) {
        const RenderedScene result = renderScene(furnace(boxOf(squares), 1000));
        EXPECT_EQ(result.totals.losses.cutPaths + result.totals.losses.nonFiniteSamples, 0u);
        EXPECT_EQ(result.totals.paths, 16u * 16u * 4u);
        // One ray in four million leaves through an edge: one path in 4000, which takes up to
        // 1 / 1024 of this mean along. Two in 1024 are rare.
        EXPECT_NEAR(imageMean(result.image).x, 1.0 - std::pow(kAlbedo, 1001), 2e-3) << squares;
    }
}

/// Splinters along one diagonal of a cube: the box of each is the cube's, so every ray through the
/// cube visits all of them and meets none.
Shape splinters(uint32_t count) {
    Mesh mesh;
    constexpr uint32_t kNo = Mesh::kNoNormal;
    for (uint32_t i = 0; i < count; ++i) {
        const double width = 1e-3 * (i + 1) / count;
        mesh.positions.insert(mesh.positions.end(),
                              {{-1, -1, -1}, {1, 1, 1}, {-1 + width, -1, -1}});
        mesh.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, {kNo, kNo, kNo}, 0});
    }
    Shape shape;
    shape.geometry = std::move(mesh);
    return shape;
}

/// Hairs along one diagonal of a cube, by whose box every ray through the cube visits all of them.
Shape hair() {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0));
    const glm::dvec3 side = glm::normalize(glm::cross(axis, {0.0, 0.0, 1.0}));
    return makeShape(
        Cylinder{{glm::dmat3(side, axis, glm::cross(side, axis)), {}}, 1e-6, 2.0 * std::sqrt(3.0)},
        0);
}

// One pass of a loop for each, and not one of every loop: by the wall's size the hairs are few.
TEST_F(LongPathTest, RaysVisitAsManyQuadricsAsPassesAreLeft) {
    SceneBuilder builder;
    builder.material(0.0, 0.0);
    builder.rectangle({-2000, -2000, -3}, {4000, 0, 0}, {0, 4000, 0}, builder.material(0.0, 1.0));
    for (int i = 0; i < 30'000; ++i)
        builder.add(hair());
    Scene& scene = builder.scene();
    scene.film = {8, 8};
    scene.render = {1, 1, 0};
    builder.lookAtPlaneZ(1.0);
    scene.camera.position = {0.6, -0.4, 5.0}; // clear of the diagonal itself
    const RenderedScene result = renderScene(scene);
    EXPECT_FALSE(result.needed.enabled[shared::kFeatureManyQuadrics]);
    EXPECT_EQ(result.totals.losses.cutPaths, 0u);
    for (const glm::vec3& pixel : result.image.pixels)
        EXPECT_EQ(pixel.x, 1.0f);
}

// Where one ray alone outgrows the loops the driver breaks them off, and a ray that should have met
// the wall behind may meet nothing. Each pixel that lacks its light is counted as cut, and none of
// those aside, whose rays miss the splinters.
TEST_F(LongPathTest, RaysThatOutgrowTheLoopsAreCounted) {
    SceneBuilder builder;
    builder.material(0.0, 0.0);
    builder.rectangle({-10, -10, -3}, {20, 0, 0}, {0, 20, 0}, builder.material(0.0, 1.0));
    builder.add(splinters(60'000));
    Scene& scene = builder.scene();
    scene.film = {16, 16};
    scene.render = {1, 1, 0};
    builder.lookAtPlaneZ(4.0);                // the columns from the tenth on lie beside the cube
    scene.camera.position = {0.6, -0.4, 5.0}; // clear of the diagonal itself
    const RenderedScene result = renderScene(scene);
    uint64_t dark = 0;
    uint64_t missing = 0;
    for (uint32_t y = 0; y < 16; ++y) {
        for (uint32_t x = 0; x < 16; ++x) {
            const bool isDark = result.image.pixels[16 * y + x].x < 1.0f;
            dark += isDark ? 1 : 0;
            const bool isAside = x >= 10;
            missing += isAside ? 1 : 0;
            EXPECT_FALSE(isDark && isAside) << x << ", " << y;
        }
    }
    std::cout << dark << " dark pixels of 256, " << result.totals.losses.cutPaths << " counted\n";
    EXPECT_LE(dark, result.totals.losses.cutPaths);
    EXPECT_LE(result.totals.losses.cutPaths, 256 - missing);
    if (hasLoopLimit())
        EXPECT_GT(result.totals.losses.cutPaths, 0u);
    else
        EXPECT_EQ(result.totals.losses.cutPaths, 0u);
}

} // namespace
} // namespace calotype::test
