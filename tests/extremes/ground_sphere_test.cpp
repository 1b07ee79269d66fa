// Objects of a metre on a ground that is a sphere of a thousand kilometres: they stand on it, their
// contact shadows begin where they touch it, and it does not shadow itself.
#include "extremes/picture_agreement.h"
#include "support/gpu_test.h"
#include "support/scene_builder.h"
#include "support/slow_run.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

RigidTransform at(const glm::dvec3& place) { return {glm::dmat3(1.0), place}; }

/// A ball, a cylinder, a cone and a cube, all touching y = 0, the top of the ground.
Scene objectsOnGround(double radius) {
    SceneBuilder builder;
    const uint32_t ground = builder.material(0.6, 0.0);
    const uint32_t grey = builder.material(0.4, 0.0);
    const uint32_t lamp = builder.material(0.0, 8.0, true);
    builder.add(makeShape(Sphere{at({0.0, -radius, 0.0}), radius}, ground));
    builder.add(makeShape(Sphere{at({-1.5, 0.5, 0.0}), 0.5}, grey));
    builder.add(makeShape(Cylinder{at({-0.3, 0.4, 0.3}), 0.3, 0.8}, grey));
    builder.add(makeShape(Cone{at({0.7, 0.9, 0.0}), -0.9, 0.5}, grey));
    Mesh cube = cubeMesh(1);
    for (glm::dvec3& position : cube.positions)
        position = 0.3 * position + glm::dvec3(1.7, 0.3, 0.2);
    for (Mesh::Triangle& triangle : cube.triangles)
        triangle.material = grey;
    builder.add(shapeOf(std::move(cube)));
    builder.rectangle({-1.0, 3.0, -1.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, lamp);
    Scene& scene = builder.scene();
    scene.background = glm::dvec3(0.2, 0.25, 0.3);
    scene.render.maxBounces = 4;
    scene.camera.position = {0.0, 0.7, 5.0};
    return scene;
}

class GroundSphereTest : public GpuTest, public testing::WithParamInterface<int> {};

TEST_P(GroundSphereTest, IsAsGoodAsAPlane) {
    const Scene scene = objectsOnGround(std::pow(10.0, GetParam()));
    expectAgreement(agreementWithReference(scene, scene, quickOrFull(32u, 48u), 32), 1e-4, 0.01);
}

const auto nameOfPower = [](const auto& power) { return std::to_string(power.param); };
INSTANTIATE_TEST_SUITE_P(OfTenTo, GroundSphereTest, testing::Values(6, 9), nameOfPower);
INSTANTIATE_TEST_SUITE_P(SlowOfTenTo, GroundSphereTest, testing::Values(2, 4, 5, 6, 7, 8, 9),
                         nameOfPower);

} // namespace
} // namespace calotype::test
