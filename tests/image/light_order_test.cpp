// The order of the lights in the packed scene has no meaning: the background is found by its index,
// and every light by its kind.
#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pack/alias_table.h"
#include "support/agreement.h"
#include "support/chi_square.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

constexpr uint32_t kSide = 32;
constexpr size_t kBlocks = 16;

/// A floor under one light of each kind.
Scene litFloor() {
    const auto at = [](double x, double z) { return RigidTransform{glm::dmat3(1.0), {x, 0.5, z}}; };
    Scene scene =
        sceneOf({shapeOf(Disk{{}, 4.0}), shapeOf(Sphere{at(-1.0, -1.0), 0.3}, 1),
                 shapeOf(Cylinder{at(1.0, -1.0), 0.2, 0.6}, 1),
                 shapeOf(Cone{at(-1.0, 1.0), -0.4, 0.5}, 1), shapeOf(Disk{at(1.0, 1.0), 0.4}, 1)});
    Mesh triangle = singleTriangle({-0.3, 0.6, 0.0}, {0.3, 0.7, 0.0}, {0.0, 0.6, 0.4});
    triangle.triangles[0].material = 1;
    scene.shapes.push_back(shapeOf(std::move(triangle)));
    scene.materials.resize(2);
    scene.materials[0].color = glm::dvec3(0.7);
    scene.materials[1].emission = {3.0, 2.0, 1.0};
    scene.background = {0.2, 0.3, 0.5};
    scene.camera.position = {0.0, 3.0, 5.0};
    scene.camera.forward = glm::normalize(glm::dvec3(0.0, -3.0, -5.0));
    scene.camera.up = glm::cross(scene.camera.right, scene.camera.forward);
    scene.render.maxBounces = 3;
    return scene;
}

/// The lights from the last to the first, each with its chance.
void reverseLights(GpuScene& packed) {
    std::reverse(packed.lights.begin(), packed.lights.end());
    std::vector<double> chances;
    for (const shared::Light& light : packed.lights)
        chances.push_back(light.selectionProbability);
    const std::vector<AliasColumn> columns = buildAliasTable(chances);
    const auto last = packed.lightCount - 1;
    for (uint32_t i = 0; i <= last; ++i) {
        shared::Light& light = packed.lights[i];
        light.selectionProbability = static_cast<float>(columns[i].probability);
        light.firstNumber = columns[i].firstNumber;
        light.ownNumbers = columns[i].ownNumbers;
        light.aliasNumbers = columns[i].aliasNumbers;
        light.alias = columns[i].alias;
    }
    const auto relink = [&](uint32_t& light) {
        light = light == shared::kNone ? shared::kNone : last - light;
    };
    for (shared::Triangle& triangle : packed.triangles)
        relink(triangle.light);
    for (shared::Quadric& quadric : packed.quadrics)
        relink(quadric.light);
    relink(packed.infiniteLight);
}

TileMeans render(const GpuScene& packed, const RenderSettings& settings) {
    const SceneBuffers buffers(testDevice(), packed);
    PathTracer tracer(testDevice(), packed, buffers, packed.features, settings);
    return renderTileMeans(tracer, kSide, kSide, kBlocks);
}

class LightOrderTest : public GpuTest {};

TEST_F(LightOrderTest, PictureIsTheSameInAnyOrder) {
    const Scene scene = litFloor();
    GpuScene packed = packAsProgram(scene).packed;
    ASSERT_EQ(packed.lightCount, 6u);
    ASSERT_EQ(packed.lights[packed.lightCount - 1].kind, shared::kLightBackground);
    const TileMeans inOrder = render(packed, squareSettings(scene, kSide, 11));
    reverseLights(packed);
    ASSERT_EQ(packed.lights[0].kind, shared::kLightBackground);
    ASSERT_EQ(packed.infiniteLight, 0u);
    const TileMeans reversed = render(packed, squareSettings(scene, kSide, 12));

    const Agreement agreement = compareIndependent(inOrder, reversed);
    EXPECT_LT(largest(glm::abs(agreement.wholeZ)), normalLimit(3));
    EXPECT_LT(agreement.greatestTileZ, normalLimit(3 * agreement.tiles));
    EXPECT_LT(largest(agreement.tileChiSquare), chiSquareLimit(agreement.tiles));
}

} // namespace
} // namespace calotype::test
