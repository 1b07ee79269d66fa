// A ball of glass in a room that shines alike from everywhere: whatever its index of refraction,
// all light that enters it comes out again, so that it is not to be seen.
#include <iostream>

#include "reference/reference_tracer.h"
#include "render/reference_block.h"
#include "support/agreement.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

constexpr uint32_t kSide = 32;
constexpr uint32_t kThreads = 2;
constexpr size_t kBlocks = 8;

Scene ballInAFurnace(double ior) {
    SceneBuilder builder;
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    glass.ior = ior;
    builder.add(makeShape(Sphere{{}, 0.9}, builder.material(glass)));
    builder.add(makeShape(Sphere{{}, 20.0}, builder.material(0.0, 1.0)));
    builder.lookAtPlaneZ(2.2);
    Scene scene = builder.scene();
    scene.film = {kSide, kSide};
    // Of light within glass of index 100, 0.96 stays at each event: 1e-7 after 400.
    scene.render = {16 * kBlocks, 400, 5};
    return scene;
}

double meanOf(const TileMeans& means) {
    double sum = 0.0;
    for (size_t i = 0; i < means.blocks(); ++i)
        sum += means.whole(i).x;
    return sum / static_cast<double>(means.blocks());
}

double worstOf(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

class GlassBallTest : public GpuTest, public testing::WithParamInterface<double> {};

TEST_P(GlassBallTest, KeepsTheEnergyOfAFurnace) {
    const Scene scene = ballInAFurnace(GetParam());
    const RenderSettings settings = squareSettings(scene, kSide, scene.render.seed);
    DeviceTracer device(scene, settings);
    const TileMeans seen = renderTileMeans(device.tracer(), kSide, kSide, kBlocks);
    const reference::ReferenceTracer tracer(scene, {kSide, kSide}, settings.maxBounces);
    ReferenceBlock block(tracer, settings, kThreads);
    const TileMeans wanted = renderTileMeans(block, kSide, kSide, kBlocks);

    const PairedDifference difference = comparePaired(seen, wanted);
    std::cout << "1 - mean " << 1.0 - meanOf(seen) << ", reference " << 1.0 - meanOf(wanted)
              << ", relative difference from the reference "
              << worstOf(glm::abs(difference.relative)) << " +- "
              << worstOf(difference.standardError) << "\n";
    // Each crossing of a path scales it by eta^2 or its inverse, in float: by a rounding or two.
    EXPECT_NEAR(meanOf(seen), 1.0, 1e-6);
    EXPECT_NEAR(meanOf(wanted), 1.0, 1e-12);
    EXPECT_LE(worstOf(glm::abs(difference.relative)), 1e-6);
}

std::string nameOf(const testing::TestParamInfo<double>& instance) {
    constexpr const char* kNames[] = {"Hundredth",   "TwoThirds", "One",    "OneAndAMillionth",
                                      "OneAndAHalf", "Four",      "Hundred"};
    return kNames[instance.index];
}

INSTANTIATE_TEST_SUITE_P(OfIndex, GlassBallTest,
                         testing::Values(0.01, 1.0 / 1.5, 1.0, 1.0 + 1e-6, 1.5, 4.0, 100.0),
                         nameOf);

} // namespace
} // namespace calotype::test
