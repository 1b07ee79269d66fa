// A scene of a millimetre inside a room of ten metres, seen from as close as its size requires.
#include "extremes/picture_agreement.h"
#include "extremes/scaled_scene.h"
#include "support/gpu_test.h"
#include "support/scene_builder.h"
#include "support/slow_run.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

class CloseObjectsTest : public GpuTest, public testing::WithParamInterface<double> {};

/// everyShape at `scale`, away from the middle of a room with grey walls and a lamp.
Scene inARoom(double scale) {
    Scene scene = scaledAndMoved(everyShape(), scale, {3.0, -1.0, 2.0});
    scene.background = glm::dvec3(0.0);
    Material wall;
    wall.color = glm::dvec3(0.5);
    Material lamp;
    lamp.emission = glm::dvec3(2.0, 1.8, 1.6);
    scene.materials.insert(scene.materials.end(), {wall, lamp});
    const auto lampIndex = static_cast<uint32_t>(scene.materials.size() - 1);
    Mesh room = cubeMesh(3);
    for (glm::dvec3& position : room.positions)
        position *= 5.0;
    for (Mesh::Triangle& triangle : room.triangles)
        triangle.material = lampIndex - 1;
    scene.shapes.push_back(shapeOf(std::move(room)));
    scene.shapes.push_back(makeShape(Sphere{{glm::dmat3(1.0), {-1.0, 3.0, 1.0}}, 0.8}, lampIndex));
    return scene;
}

TEST_P(CloseObjectsTest, LookAsTheReferenceSays) {
    const Scene scene = inARoom(GetParam());
    expectAgreement(agreementWithReference(scene, scene, quickOrFull(16u, 32u), 32), 1e-4, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Scaled, CloseObjectsTest, testing::Values(1e-4));
INSTANTIATE_TEST_SUITE_P(SlowScaled, CloseObjectsTest, testing::Values(1e-2, 1e-4, 1e-5, 1e-6));

} // namespace
} // namespace calotype::test
