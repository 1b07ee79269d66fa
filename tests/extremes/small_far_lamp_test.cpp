// Lamps and the floor under them, so small that single precision rounds their places badly: how
// much light is lost or gained in all.
#include "check/small_shapes.h"
#include "extremes/judgement.h"
#include "extremes/scaled_scene.h"
#include "support/gpu_test.h"
#include "support/scene_builder.h"
#include "support/slow_run.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

/// Metres from the camera along y, the axis on which it is farthest.
constexpr double kDistance = 1e5;

/// One metre large, half a metre above the origin.
struct LampKind {
    const char* name;
    Shape shape; ///< of material 0
};

void PrintTo(const LampKind& kind, std::ostream* stream) { *stream << kind.name; }

const LampKind kKinds[] = {
    {"Sphere", makeShape(Sphere{{glm::dmat3(1.0), {0.0, 1.0, 0.0}}, 0.5}, 0)},
    {"Cylinder", makeShape(Cylinder{{glm::dmat3(1.0), {0.0, 1.0, 0.0}}, 0.5, 1.0}, 0)},
    {"Cone", makeShape(Cone{{glm::dmat3(1.0), {0.0, 1.5, 0.0}}, -1.0, 0.5}, 0)},
    {"Disk", makeShape(Disk{{glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, -1), {0.0, 1.0, 0.0}}, 0.5}, 0)},
    {"Mesh", shapeOf(icosphere(2, {0.0, 1.0, 0.0}, 0.5))},
};

/// `lamp` and a floor six times as wide, `size` metres large, seen askew and as a whole from
/// kDistance.
Scene farLamp(const Shape& lamp, double size) {
    SceneBuilder builder;
    builder.material(0.0, 1.0);
    const uint32_t floor = builder.material(0.5, 0.0);
    builder.add(lamp);
    builder.polygon({{-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}}, floor);
    Scene scene = scaledAndMoved(builder.scene(), size, {});
    scene.render.maxBounces = 2;
    Camera camera;
    camera.projection = Projection::Orthographic;
    camera.position = kDistance * glm::dvec3(0.77, 1.0, 0.54);
    camera.forward = -glm::normalize(camera.position);
    camera.right = glm::normalize(glm::cross(camera.forward, {0.0, 1.0, 0.0}));
    camera.up = glm::cross(camera.right, camera.forward);
    camera.viewHeight = 10.0 * size;
    scene.camera = camera;
    // Behind the camera, so that the scene is packed about the camera.
    scene.shapes.push_back(
        makeShape(Sphere{{glm::dmat3(1.0), 1.001 * camera.position}, 1e-3}, floor));
    return scene;
}

class SmallFarLampTest : public GpuTest, public testing::WithParamInterface<LampKind> {};
using SlowSmallFarLampTest = SmallFarLampTest;

TEST_P(SmallFarLampTest, IsOffByAPercentWhereInfoWarns) {
    expectJudgement(
        judge(farLamp(GetParam().shape, kSmallestShare * kDistance), quickOrFull(32u, 64u), 16),
        0.01);
}

TEST_P(SlowSmallFarLampTest, IsOffByTheInverseOfItsSize) {
    expectJudgement(judge(farLamp(GetParam().shape, 16.0 * kSmallestShare * kDistance), 64, 128),
                    0.01 / 16.0);
}

const auto nameOfKind = [](const auto& kind) { return std::string(kind.param.name); };
INSTANTIATE_TEST_SUITE_P(Of, SmallFarLampTest, testing::ValuesIn(kKinds), nameOfKind);
INSTANTIATE_TEST_SUITE_P(SlowOf, SmallFarLampTest, testing::ValuesIn(kKinds), nameOfKind);
INSTANTIATE_TEST_SUITE_P(Of, SlowSmallFarLampTest, testing::ValuesIn(kKinds), nameOfKind);

} // namespace
} // namespace calotype::test
