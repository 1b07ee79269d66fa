// Ways of looking for light: they change what a picture costs and how it is noisy, and not what it
// tends to; but for the clamp, which takes light away.
#include <algorithm>
#include <iostream>

#include "reference/reference_tracer.h"
#include "render/reference_block.h"
#include "support/agreement.h"
#include "support/chi_square.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/slow_run.h"

namespace calotype::test {
namespace {

class TransportTest : public GpuTest {
protected:
    static constexpr size_t kBlocks = 64;

    /// The quick run's pictures have a quarter of the pixels: it sees twice the bias.
    static TileMeans means(const Scene& scene, const TransportSettings& transport, uint32_t seed) {
        const uint32_t side = quickOrFull(16u, 32u);
        RenderSettings settings = squareSettings(scene, side, seed);
        settings.transport = transport;
        DeviceTracer device(scene, settings);
        return renderTileMeans(device.tracer(), side, side, kBlocks);
    }

    /// From other random numbers; normal deviates stay below their limit but once in 10,000 times.
    static void expectSamePicture(const TileMeans& a, const TileMeans& b) {
        const Agreement agreement = compareIndependent(a, b);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_LT(std::abs(agreement.wholeZ[channel]), normalLimit(3));
            EXPECT_LT(agreement.tileChiSquare[channel], chiSquareLimit(agreement.tiles));
        }
        EXPECT_LT(agreement.greatestTileZ, normalLimit(3 * agreement.tiles));
        std::cout << "|z| " << largest(glm::abs(agreement.wholeZ)) << ", of tiles "
                  << agreement.greatestTileZ << "\n";
    }

    static double brightness(const TileMeans& means) {
        double sum = 0.0;
        for (size_t block = 0; block < means.blocks(); ++block)
            sum += means.whole(block).g / static_cast<double>(means.blocks());
        return sum;
    }
};

TEST_F(TransportTest, RouletteKeepsThePicture) {
    TransportSettings wholePaths;
    wholePaths.usesRoulette = false;
    std::vector<const char*> paths = {"scenes/cornell-box.json", "scenes/dielectric.json"};
    if (isSlowRun())
        paths.push_back("tests/image/scenes/lanterns.json");
    for (const char* path : paths) {
        SCOPED_TRACE(path);
        Scene scene = projectScene(path);
        scene.render.maxBounces = 16;
        expectSamePicture(means(scene, {}, 1), means(scene, wholePaths, 2));
    }
}
ALSO_SLOW(TransportTest, RouletteKeepsThePicture);

TEST_F(TransportTest, RouletteShortensPaths) {
    const Scene scene = projectScene("scenes/cornell-box.json");
    RenderWish wish;
    wish.width = wish.height = 32;
    wish.samplesPerPixel = 16;
    wish.maxBounces = 32;
    const RenderTotals with = renderScene(scene, wish).totals;
    wish.transport.usesRoulette = false;
    const RenderTotals without = renderScene(scene, wish).totals;
    EXPECT_EQ(with.paths, without.paths);
    EXPECT_LT(static_cast<double>(with.rays), 0.7 * static_cast<double>(without.rays));
}

TEST_F(TransportTest, SamplingLightsAloneKeepsThePicture) {
    TransportSettings lightsOnly;
    lightsOnly.usesMis = false;
    std::vector<const char*> paths = {"scenes/background.json", "scenes/dielectric.json"};
    if (isSlowRun())
        paths.push_back("scenes/cornell-box.json");
    for (const char* path : paths) {
        SCOPED_TRACE(path);
        const Scene scene = projectScene(path);
        expectSamePicture(means(scene, {}, 3), means(scene, lightsOnly, 4));
    }
}
ALSO_SLOW(TransportTest, SamplingLightsAloneKeepsThePicture);

TEST_F(TransportTest, ChoosingLightsAlikeKeepsThePicture) {
    for (const char* path : {"scenes/cornell-box.json", "tests/image/scenes/lanterns.json"}) {
        SCOPED_TRACE(path);
        const Scene scene = projectScene(path);
        TransportSettings uniform;
        uniform.lightChoice = LightChoice::Uniform;
        expectSamePicture(means(scene, {}, 5), means(scene, uniform, 6));
    }
}
ALSO_SLOW(TransportTest, ChoosingLightsAlikeKeepsThePicture);

// Lamps of all kinds; the tree against the alias table.
TEST_F(TransportTest, ChoosingLightsByATreeKeepsThePicture) {
    for (const char* path : {"tests/image/scenes/lamps.json", "tests/image/scenes/lanterns.json"}) {
        SCOPED_TRACE(path);
        const Scene scene = projectScene(path);
        TransportSettings byTree;
        byTree.lightChoice = LightChoice::Tree;
        expectSamePicture(means(scene, {}, 15), means(scene, byTree, 16));
    }
}
ALSO_SLOW(TransportTest, ChoosingLightsByATreeKeepsThePicture);

// Without directions of the BSDF, nothing makes up for a light that the tree leaves out. Lobes are
// wide, because lights are hardly ever sampled where a narrow one reflects them.
TEST_F(TransportTest, LightsOfATreeAloneKeepThePicture) {
    Scene scene = projectScene("tests/image/scenes/lanterns.json");
    for (Material& material : scene.materials) {
        material.roughness = std::max(material.roughness, 0.5);
        material.exponent = std::min(material.exponent, 20.0);
    }
    TransportSettings uniform;
    uniform.lightChoice = LightChoice::Uniform;
    TransportSettings byTree;
    byTree.lightChoice = LightChoice::Tree;
    byTree.usesMis = false;
    expectSamePicture(means(scene, uniform, 17), means(scene, byTree, 18));
}
ALSO_SLOW(TransportTest, LightsOfATreeAloneKeepThePicture);

// The reference tracer can sample all lights at each event; the expected picture is the same.
TEST_F(TransportTest, AskingAllLightsKeepsThePicture) {
    constexpr uint32_t kSmall = 16;
    const Scene scene = projectScene("tests/image/scenes/lanterns.json");
    const RenderSettings settings = squareSettings(scene, kSmall, 8);
    TransportSettings allLights;
    allLights.lightChoice = LightChoice::All;
    const auto referenceMeans = [&] {
        const reference::ReferenceTracer tracer(scene, {kSmall, kSmall}, settings.maxBounces,
                                                allLights);
        ReferenceBlock block(tracer, settings, 2);
        return renderTileMeans(block, kSmall, kSmall, kBlocks);
    };
    const TileMeans all = referenceMeans();
    DeviceTracer device(scene, squareSettings(scene, kSmall, 9));
    expectSamePicture(all, renderTileMeans(device.tracer(), kSmall, kSmall, kBlocks));
}

// The same random numbers: no tile gets brighter, direct light stays, and what is lost is what the
// clamp is for.
TEST_F(TransportTest, ClampOnlyTakesIndirectLightAway) {
    Scene scene = projectScene("scenes/cornell-box.json");
    const TileMeans whole = means(scene, {}, 7);
    double least = brightness(whole);
    for (const float clamp : {1.0f, 0.1f, 1e-6f}) {
        TransportSettings clamped;
        clamped.indirectClamp = clamp;
        const TileMeans dimmed = means(scene, clamped, 7);
        for (size_t block = 0; block < kBlocks; ++block)
            for (size_t tile = 0; tile < dimmed.tiles(); ++tile)
                EXPECT_LE(dimmed.at(block, tile).g, whole.at(block, tile).g * (1.0 + 1e-6));
        EXPECT_LT(brightness(dimmed), least);
        least = brightness(dimmed);
        std::cout << "clamp " << clamp << ": " << 100.0 * (1.0 - least / brightness(whole))
                  << " % darker\n";
    }
    scene.render.maxBounces = 1;
    EXPECT_NEAR(least / brightness(means(scene, {}, 7)), 1.0, 1e-4)
        << "what is left is direct light";
}
ALSO_SLOW(TransportTest, ClampOnlyTakesIndirectLightAway);

} // namespace
} // namespace calotype::test
