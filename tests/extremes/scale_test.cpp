// The same scene a million times smaller or larger, and moved by a million times its size, gives
// the same picture: the reference tracer's of the scene as it was. And what is closed stays dark.
#include <array>

#include "extremes/closed_meshes.h"
#include "extremes/picture_agreement.h"
#include "extremes/scaled_scene.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/slow_run.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

constexpr double kSize = 10.0; ///< of everyShape, metres
const glm::dvec3 kFarAway = 1e6 * kSize * glm::dvec3(1.0, -0.5, 0.7);

struct Placement {
    const char* name;
    double scale;
    glm::dvec3 offset; ///< at scale 1
};

void PrintTo(const Placement& placement, std::ostream* stream) { *stream << placement.name; }

class ScaledSceneTest : public GpuTest, public testing::WithParamInterface<Placement> {};

TEST_P(ScaledSceneTest, GivesTheSamePicture) {
    const auto& [name, scale, offset] = GetParam();
    const Scene scene = everyShape();
    const Scene placed = scaledAndMoved(scene, scale, scale * offset);
    expectAgreement(agreementWithReference(placed, scene, quickOrFull(16u, 32u), 32), 1e-4, 0.01);
}

/// White within, seen from within, in a world that shines from everywhere.
Scene insideOf(Shape shape) {
    Scene scene = sceneOf({std::move(shape)});
    scene.materials[0].color = glm::dvec3(1.0);
    scene.background = glm::dvec3(1.0);
    scene.camera.position = {0.1, 0.002, 0.0015};
    scene.camera.verticalFov = 2.0;
    scene.render.maxBounces = 30;
    return scene;
}

/// By 10,000 rays for each pixel, in all shapes together.
void expectDark(const Placement& placement, uint32_t side) {
    const Shape closed[] = {
        shapeOf(Sphere{{}, 1.0}),
        shapeOf(Cylinder{{}, 1.0, 2.0}),
        shapeOf(Cone{{glm::dmat3(1.0), {0.0, 1.0, 0.0}}, -2.0, 1.0}),
        shapeOf(turned(cubeMesh(3))),
        shapeOf(displacedBall(3)),
    };
    for (const Shape& shape : closed) {
        RenderWish wish;
        wish.width = wish.height = side;
        wish.samplesPerPixel = 64;
        const RenderedScene result = renderScene(
            scaledAndMoved(insideOf(shape), placement.scale, placement.scale * placement.offset),
            wish);
        EXPECT_EQ(result.totals.losses.cutPaths + result.totals.losses.nonFiniteSamples, 0u);
        size_t lit = 0;
        for (const glm::vec3& pixel : result.image.pixels)
            lit += pixel != glm::vec3(0.0f) ? 1 : 0;
        // A point within rounding of a mesh's edge, moved off its own triangle, may lie beyond the
        // next one: in these meshes that happens to one ray in four million.
        const bool isMesh = std::holds_alternative<Mesh>(shape.geometry);
        const double rays = 64.0 * 30.0 * side * side;
        EXPECT_LE(lit, isMesh ? 3.0 + rays / 1e6 : 0.0) << "of closed shape " << &shape - closed;
    }
}

TEST_P(ScaledSceneTest, LetsNoLightIntoWhatIsClosed) { expectDark(GetParam(), 16); }

using SlowScaledSceneTest = ScaledSceneTest;
TEST_P(SlowScaledSceneTest, LetsNoLightIntoWhatIsClosed) { expectDark(GetParam(), 64); }

// The ends of the range, and what lies between them.
const Placement kEnds[] = {{"Millionth", 1e-6, {}},
                           {"TenToMinus11", 1e-11, {}},
                           {"TenTo11", 1e11, {}},
                           {"MillionthFarAway", 1e-6, kFarAway},
                           {"MillionFarAway", 1e6, kFarAway}};
const Placement kOthers[] = {{"One", 1.0, {}},
                             {"Thousandth", 1e-3, {}},
                             {"Thousand", 1e3, {}},
                             {"Million", 1e6, {}},
                             {"OneFarAway", 1.0, kFarAway}};
const auto nameOfPlacement = [](const auto& placement) {
    return std::string(placement.param.name);
};
const auto ends = testing::ValuesIn(kEnds);
const auto others = testing::ValuesIn(kOthers);
INSTANTIATE_TEST_SUITE_P(By, ScaledSceneTest, ends, nameOfPlacement);
INSTANTIATE_TEST_SUITE_P(SlowBy, ScaledSceneTest, ends, nameOfPlacement);
INSTANTIATE_TEST_SUITE_P(SlowOtherwiseBy, ScaledSceneTest, others, nameOfPlacement);
INSTANTIATE_TEST_SUITE_P(By, SlowScaledSceneTest, ends, nameOfPlacement);
INSTANTIATE_TEST_SUITE_P(OtherwiseBy, SlowScaledSceneTest, others, nameOfPlacement);

} // namespace
} // namespace calotype::test
