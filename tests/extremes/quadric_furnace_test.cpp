// Inside cylinders and cones of extreme proportions that emit and reflect alike everywhere the
// radiance is emission / (1 - albedo), wherever one looks: nothing leaks out of so thin a room.
#include <iostream>

#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"
#include "support/slow_run.h"

namespace calotype::test {
namespace {

struct Room {
    std::string name;
    Shape shape;
    glm::dvec3 camera; ///< inside
};

void PrintTo(const Room& room, std::ostream* stream) { *stream << room.name; }

std::vector<Room> rooms() {
    const auto cylinder = [](double radius, double height) {
        return makeShape(Cylinder{{}, radius, height}, 0);
    };
    const auto cone = [](double height, double slope) {
        return makeShape(Cone{{}, height, slope}, 0);
    };
    return {{"LongCylinder", cylinder(1.0, 1e5), {0.3, 10.0, 0.2}},
            {"FlatCylinder", cylinder(1e5, 1.0), {10.0, 0.2, 5.0}},
            {"LongCone", cone(-1e5, 1e-5), {0.1, -5e4, 0.2}},
            {"FlatCone", cone(1.0, 1e5), {10.0, 0.8, 5.0}}};
}

class QuadricFurnaceTest : public GpuTest, public testing::WithParamInterface<Room> {};

TEST_P(QuadricFurnaceTest, ShowsRadianceOne) {
    SceneBuilder builder;
    builder.material(0.5, 0.5);
    builder.add(GetParam().shape);
    Scene& scene = builder.scene();
    scene.film = {32, 32};
    scene.render = {quickOrFull(64u, 256u), 20, 1};
    scene.camera.position = GetParam().camera;
    scene.camera.verticalFov = 1.5;
    RenderWish wish;
    wish.transport.usesRoulette = false; // else paths of one length would be unlike
    const RenderedScene result = renderScene(scene, wish);
    const double mean = imageMean(result.image).x;
    std::cout << "mean " << mean << "\n";
    EXPECT_NEAR(mean, 1.0, 1e-4); // the noise of 65,536 samples is about 2e-5
    EXPECT_EQ(result.totals.losses.nonFiniteSamples, 0u);
    EXPECT_EQ(result.totals.losses.cutPaths, 0u);
}

const auto nameOfRoom = [](const auto& instance) { return instance.param.name; };
INSTANTIATE_TEST_SUITE_P(Of, QuadricFurnaceTest, testing::ValuesIn(rooms()), nameOfRoom);
INSTANTIATE_TEST_SUITE_P(SlowOf, QuadricFurnaceTest, testing::ValuesIn(rooms()), nameOfRoom);

} // namespace
} // namespace calotype::test
