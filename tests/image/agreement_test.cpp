// The device against the reference tracer, path by path and in the mean.
#include <iostream>

#include <glm/common.hpp>

#include "image/judged_scenes.h"
#include "reference/reference_tracer.h"
#include "render/reference_block.h"
#include "support/agreement.h"
#include "support/chi_square.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

constexpr uint32_t kThreads = 2;
constexpr uint32_t kSeed = 7;

/// A scene for both tracers, as a square picture. Keeps a reference to the scene.
class Judged {
public:
    Judged(const Scene&&, uint32_t, Sampler = Sampler::Independent,
           const TransportSettings& = {}) = delete;
    Judged(const Scene& scene, uint32_t side, Sampler sampler = Sampler::Independent,
           const TransportSettings& transport = {})
        : settings_(settingsOf(scene, side, sampler, transport)),
          reference_(scene, {side, side}, settings_.maxBounces, transport),
          block_(reference_, settings_, kThreads), device_(scene, settings_) {}

    BlockTracer& reference() { return block_; }
    BlockTracer& device() { return device_.tracer(); }

    TileMeans referenceMeans(size_t blocks) { return means(block_, blocks); }
    TileMeans deviceMeans(size_t blocks) { return means(device_.tracer(), blocks); }

private:
    static RenderSettings settingsOf(const Scene& scene, uint32_t side, Sampler sampler,
                                     const TransportSettings& transport) {
        RenderSettings settings = squareSettings(scene, side, kSeed);
        settings.sampler = sampler;
        settings.transport = transport;
        return settings;
    }

    TileMeans means(BlockTracer& tracer, size_t blocks) {
        return renderTileMeans(tracer, settings_.width, settings_.height, blocks);
    }

    RenderSettings settings_;
    reference::ReferenceTracer reference_;
    ReferenceBlock block_;
    DeviceTracer device_;
};

/// The device's picture from other random numbers.
TileMeans independentMeans(const Scene& scene, uint32_t side, size_t blocks) {
    DeviceTracer device(scene, squareSettings(scene, side, kSeed + 1));
    return renderTileMeans(device.tracer(), side, side, blocks);
}

class AgreementTest : public GpuTest, public testing::WithParamInterface<JudgedScene> {
protected:
    Scene scene_ = projectScene(GetParam().path);
};

// Paths from the same random numbers are the same but where rounding tips a decision: which of two
// lights, lobes or surfaces a number or a ray at their very border falls to.
TEST_P(AgreementTest, PathsAreTheSame) {
    constexpr uint32_t kSide = 96;
    Judged judged(scene_, kSide);
    const double share = differingShare(judged.device(), judged.reference());
    EXPECT_LE(share, GetParam().mostDiffering);
    std::cout << "differ by a thousandth: " << 100.0 * share << " %\n";
}

// The same random numbers: what differs is arithmetic, and it has no bias.
TEST_P(AgreementTest, MeansOfTheSamePathsAreEqual) {
    constexpr uint32_t kSide = 32;
    constexpr size_t kBlocks = 32;
    constexpr double kBound = 1e-4; // relative
    Judged judged(scene_, kSide);
    const PairedDifference difference =
        comparePaired(judged.deviceMeans(kBlocks), judged.referenceMeans(kBlocks));
    // A few paths differ by chance, where rounding sends them another way. What they differ by has
    // a mean of zero, and its noise comes on top of the bound; it is 0 where no path differs.
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_LT(std::abs(difference.relative[channel]),
                  kBound + normalLimit(3) * difference.standardError[channel])
            << "channel " << channel;
    std::cout << "relative difference " << largest(glm::abs(difference.relative)) << " +- "
              << largest(difference.standardError) << "\n";
}

void expectAgreement(const Agreement& agreement) {
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_LT(std::abs(agreement.wholeZ[channel]), normalLimit(3)) << "channel " << channel;
        EXPECT_LT(agreement.tileChiSquare[channel], chiSquareLimit(agreement.tiles))
            << "channel " << channel;
    }
    EXPECT_LT(agreement.greatestTileZ, normalLimit(3 * agreement.tiles));
}

// Independent random numbers: as a stranger would compare two renderers.
TEST_P(AgreementTest, PicturesOfOtherPathsAgree) {
    constexpr uint32_t kSide = 32;
    constexpr size_t kBlocks = 32;
    Judged judged(scene_, kSide);
    const Agreement agreement = compareIndependent(independentMeans(scene_, kSide, kBlocks),
                                                   judged.referenceMeans(kBlocks));
    expectAgreement(agreement);
    const glm::dvec3 z = glm::abs(agreement.wholeZ);
    std::cout << "|z| of the picture " << largest(z) << ", of its tiles up to "
              << agreement.greatestTileZ << ", chi-square by tile "
              << largest(agreement.tileChiSquare) / static_cast<double>(agreement.tiles) << "\n";
}

INSTANTIATE_TEST_SUITE_P(Scenes, AgreementTest, testing::ValuesIn(kJudgedScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

using JudgedScenesTest = GpuTest;

// Lights, lobes, a lens and alpha all draw from Sobol's points as the reference does.
TEST_F(JudgedScenesTest, PathsOfSobolsPointsAreTheSame) {
    constexpr uint32_t kSide = 64;
    for (const char* path : {"scenes/cornell-box.json", "scenes/depth-of-field.json"}) {
        const Scene scene = projectScene(path);
        Judged judged(scene, kSide, Sampler::Sobol);
        // As of the judged scenes, none of which but normal-mapped ones differs in more.
        EXPECT_LE(differingShare(judged.device(), judged.reference()), 2e-4) << path;
    }
}

// Whatever way of looking for light: glass, which scales radiance, and paths long enough to end by
// roulette among them.
TEST_F(JudgedScenesTest, PathsOfEveryTransportAreTheSame) {
    constexpr uint32_t kSide = 64;
    TransportSettings lightsOnly;
    lightsOnly.usesMis = false;
    TransportSettings wholePaths;
    wholePaths.usesRoulette = false;
    TransportSettings clamped;
    clamped.indirectClamp = 0.3f;
    for (const char* path :
         {"scenes/cornell-box.json", "scenes/dielectric.json", "scenes/background.json"})
        for (const LightChoice choice : {LightChoice::Power, LightChoice::Uniform})
            for (TransportSettings transport :
                 {TransportSettings{}, lightsOnly, wholePaths, clamped}) {
                Scene scene = projectScene(path);
                scene.render.maxBounces = 24;
                transport.lightChoice = choice;
                Judged judged(scene, kSide, Sampler::Independent, transport);
                // Five times as many events as in the judged scenes, as many roundings.
                EXPECT_LE(differingShare(judged.device(), judged.reference()), 2.5e-3) << path;
            }
}

TEST_F(JudgedScenesTest, NeedEveryFeatureTogether) {
    SceneFeatures together{};
    for (const JudgedScene& judged : kJudgedScenes) {
        const Scene scene = projectScene(judged.path);
        const SceneFeatures needed =
            DeviceTracer(scene, squareSettings(scene, 8, kSeed)).packed().features;
        for (size_t i = 0; i < needed.enabled.size(); ++i)
            together.enabled[i] = together.enabled[i] || needed.enabled[i];
    }
    for (size_t i = 0; i < together.enabled.size(); ++i)
        EXPECT_TRUE(together.enabled[i]) << kFeatureNames[i];
}

using PlantedBiasTest = GpuTest;

/// Smooth: no small light, hardly any gloss.
Scene smoothScene() { return projectScene("scenes/background.json"); }

// The test above with 4.5 times its samples: it judges two renderings of one light as equal, and
// detects a light that is brighter by 0.2 % in one channel.
TEST_F(PlantedBiasTest, OfAFiveHundredthIsCaughtInEveryChannel) {
    constexpr uint32_t kSide = 48;
    constexpr size_t kBlocks = 64;
    const Scene honest = smoothScene();
    const TileMeans expected = Judged(honest, kSide).referenceMeans(kBlocks);
    expectAgreement(compareIndependent(independentMeans(honest, kSide, kBlocks), expected));
    for (int channel = 0; channel < 3; ++channel) {
        Scene biased = honest;
        biased.background[channel] *= 1.002;
        for (Material& material : biased.materials)
            material.emission[channel] *= 1.002;
        const Agreement agreement =
            compareIndependent(independentMeans(biased, kSide, kBlocks), expected);
        EXPECT_GT(std::abs(agreement.wholeZ[channel]), normalLimit(3)) << "channel " << channel;
        std::cout << "channel " << channel << ": |z| " << std::abs(agreement.wholeZ[channel])
                  << ", limit " << normalLimit(3) << "\n";
    }
}

} // namespace
} // namespace calotype::test
