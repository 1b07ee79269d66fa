// The device against the reference tracer, path by path and in the mean.
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <glm/common.hpp>

#include "engine/compile_scene.h"
#include "image/judged_scenes.h"
#include "reference/reference_tracer.h"
#include "render/reference_block.h"
#include "support/agreement.h"
#include "support/chi_square.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/slow_run.h"
#include "support/statistics.h"

namespace calotype::test {
namespace {

constexpr uint32_t kThreads = 2;
constexpr uint32_t kSeed = 7;

/// A scene for both tracers, as a square picture. Keeps a reference to the scene.
class Judged {
public:
    Judged(const Scene&&, uint32_t, Sampler = Sampler::Independent,
           const std::optional<TransportSettings>& = {}) = delete;
    Judged(const Scene& scene, uint32_t side, Sampler sampler = Sampler::Independent,
           const std::optional<TransportSettings>& transport = {})
        : settings_(settingsOf(scene, side, sampler, transport)), scene_(scene),
          reference_(scene, {side, side}, settings_.maxBounces, settings_.transport),
          block_(reference_, settings_, kThreads) {}

    BlockTracer& reference() { return block_; }
    /// Compiles the kernel when it is called for the first time.
    BlockTracer& device() {
        if (!device_)
            device_.emplace(scene_, settings_);
        return device_->tracer();
    }

    TileMeans referenceMeans(size_t blocks) { return means(block_, blocks); }
    TileMeans deviceMeans(size_t blocks) { return means(device(), blocks); }

private:
    static RenderSettings settingsOf(const Scene& scene, uint32_t side, Sampler sampler,
                                     const std::optional<TransportSettings>& transport) {
        RenderSettings settings = squareSettings(scene, side, kSeed);
        settings.sampler = sampler;
        settings.transport = transport.value_or(settings.transport);
        return settings;
    }

    TileMeans means(BlockTracer& tracer, size_t blocks) {
        return renderTileMeans(tracer, settings_.width, settings_.height, blocks);
    }

    RenderSettings settings_;
    const Scene& scene_;
    reference::ReferenceTracer reference_;
    ReferenceBlock block_;
    std::optional<DeviceTracer> device_;
};

class AgreementTest : public GpuTest, public testing::WithParamInterface<JudgedScene> {};

// Paths from the same random numbers are the same but where rounding tips a decision: which of two
// lights, lobes or surfaces a number or a ray at their very border falls to.
TEST_P(AgreementTest, PathsAreTheSame) {
    constexpr uint32_t kSide = 96;
    const Scene scene = projectScene(GetParam().path);
    Judged judged(scene, kSide);
    const double share = differingShare(judged.device(), judged.reference());
    EXPECT_LE(share, GetParam().mostDiffering);
    std::cout << "differ by a thousandth: " << 100.0 * share << " %\n";
}

/// What both tracers make of a judged scene.
struct SceneMeans {
    TileMeans reference;
    TileMeans same;  ///< the device's from the same random numbers
    TileMeans other; ///< and from others: later samples
};

/// Rendered once for all tests of a process. The quick run's quarter of the pixels doubles the
/// standard error of a mean, and keeps the number of blocks that it is measured by.
const SceneMeans& sceneMeans(const JudgedScene& judgedScene) {
    static std::map<std::pair<std::string, uint32_t>, SceneMeans> known;
    constexpr size_t kBlocks = 32;
    const uint32_t side = quickOrFull(16u, 32u);
    const std::pair key(std::string(judgedScene.path), side);
    const auto at = known.find(key);
    if (at != known.end())
        return at->second;
    const Scene scene = projectScene(judgedScene.path);
    Judged judged(scene, side);
    return known
        .emplace(key, SceneMeans{judged.referenceMeans(kBlocks), judged.deviceMeans(kBlocks),
                                 renderTileMeans(judged.device(), side, side, kBlocks, kBlocks)})
        .first->second;
}

/// The standard error of the picture's mean over its blocks, as a share of that mean.
double relativeNoise(const TileMeans& means, int channel) {
    std::vector<double> values;
    for (size_t block = 0; block < means.blocks(); ++block)
        values.push_back(means.whole(block)[channel]);
    const Estimate mean = estimate(values);
    return mean.standardError / mean.mean;
}

// The same random numbers: what differs is arithmetic, and it has no bias.
TEST_P(AgreementTest, MeansOfTheSamePathsAreEqual) {
    constexpr double kBound = 1e-4; // relative
    const SceneMeans& means = sceneMeans(GetParam());
    const PairedDifference difference = comparePaired(means.same, means.reference);
    // A few paths differ by chance, where rounding sends them another way. What they differ by has
    // a mean of zero, and its noise comes on top of the bound; it is 0 where no path differs.
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_LT(std::abs(difference.relative[channel]),
                  kBound + normalLimit(3) * difference.standardError[channel])
            << "channel " << channel;
        // Of independent paths it would be more than the picture's own noise.
        EXPECT_LT(difference.standardError[channel], 0.5 * relativeNoise(means.reference, channel))
            << "channel " << channel;
    }
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
    const SceneMeans& means = sceneMeans(GetParam());
    const Agreement agreement = compareIndependent(means.other, means.reference);
    expectAgreement(agreement);
    const glm::dvec3 z = glm::abs(agreement.wholeZ);
    std::cout << "|z| of the picture " << largest(z) << ", of its tiles up to "
              << agreement.greatestTileZ << ", chi-square by tile "
              << largest(agreement.tileChiSquare) / static_cast<double>(agreement.tiles) << "\n";
}

const auto nameOfScene = [](const auto& scene) { return std::string(scene.param.name); };
INSTANTIATE_TEST_SUITE_P(Scenes, AgreementTest, testing::ValuesIn(kJudgedScenes), nameOfScene);
INSTANTIATE_TEST_SUITE_P(SlowScenes, AgreementTest, testing::ValuesIn(kJudgedScenes), nameOfScene);

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
// roulette among them. How lights are chosen is a table of the scene, whatever else the kernel
// does: the quick run changes one of both at a time.
TEST_F(JudgedScenesTest, PathsOfEveryTransportAreTheSame) {
    constexpr uint32_t kSide = 64;
    TransportSettings lightsOnly;
    lightsOnly.usesMis = false;
    TransportSettings wholePaths;
    wholePaths.usesRoulette = false;
    TransportSettings clamped;
    clamped.indirectClamp = 0.3f;
    const TransportSettings usual;
    std::vector<TransportSettings> changes = {usual, lightsOnly, wholePaths, clamped};
    for (const LightChoice choice : {LightChoice::Power, LightChoice::Uniform}) {
        if (choice == LightChoice::Uniform && !isSlowRun())
            changes = {usual};
        for (const char* path :
             {"scenes/cornell-box.json", "scenes/dielectric.json", "scenes/background.json"})
            for (TransportSettings transport : changes) {
                Scene scene = projectScene(path);
                scene.render.maxBounces = 24;
                transport.lightChoice = choice;
                Judged judged(scene, kSide, Sampler::Independent, transport);
                // Five times as many events as in the judged scenes, as many roundings.
                EXPECT_LE(differingShare(judged.device(), judged.reference()), 2.5e-3) << path;
            }
    }
}
ALSO_SLOW(JudgedScenesTest, PathsOfEveryTransportAreTheSame);

TEST_F(JudgedScenesTest, NeedEveryFeatureTogether) {
    SceneFeatures together{};
    for (const JudgedScene& judged : kJudgedScenes) {
        const Scene scene = projectScene(judged.path);
        const SceneFeatures needed =
            compileScene(scene, squareSettings(scene, 8, kSeed)).packed.features;
        for (size_t i = 0; i < needed.enabled.size(); ++i)
            together.enabled[i] = together.enabled[i] || needed.enabled[i];
    }
    for (size_t i = 0; i < together.enabled.size(); ++i)
        EXPECT_TRUE(together.enabled[i]) << kFeatureNames[i];
}

using PlantedBiasTest = GpuTest;

/// The device's picture from other random numbers.
TileMeans independentMeans(const Scene& scene, uint32_t side, size_t blocks) {
    DeviceTracer device(scene, squareSettings(scene, side, kSeed + 1));
    return renderTileMeans(device.tracer(), side, side, blocks);
}

/// Smooth: no small light, hardly any gloss.
Scene smoothScene() { return projectScene("scenes/background.json"); }

// The quick run has the counts of the slow pictures above, the slow run 4.5 times as many: it
// judges two renderings of one light as equal, and detects a light that is brighter by 0.45 % in
// one channel, and by 0.2 % in the slow run.
TEST_F(PlantedBiasTest, IsCaughtInEveryChannel) {
    const uint32_t side = quickOrFull(32u, 48u);
    const size_t blocks = quickOrFull(32, 64);
    const double bias = quickOrFull(0.0045, 0.002);
    const Scene honest = smoothScene();
    const TileMeans expected = Judged(honest, side).referenceMeans(blocks);
    expectAgreement(compareIndependent(independentMeans(honest, side, blocks), expected));
    for (int channel = 0; channel < 3; ++channel) {
        Scene biased = honest;
        biased.background[channel] *= 1.0 + bias;
        for (Material& material : biased.materials)
            material.emission[channel] *= 1.0 + bias;
        const Agreement agreement =
            compareIndependent(independentMeans(biased, side, blocks), expected);
        EXPECT_GT(std::abs(agreement.wholeZ[channel]), normalLimit(3)) << "channel " << channel;
        std::cout << "channel " << channel << ": |z| " << std::abs(agreement.wholeZ[channel])
                  << ", limit " << normalLimit(3) << "\n";
    }
}
ALSO_SLOW(PlantedBiasTest, IsCaughtInEveryChannel);

} // namespace
} // namespace calotype::test
