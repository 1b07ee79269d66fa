// Adaptive sampling on the device: the same picture, better spent samples, honest error bars.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "render/adaptive_session.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/judged_picture.h"
#include "support/render_scene.h"
#include "support/seeded_films.h"
#include "support/slow_run.h"

namespace calotype::test {
namespace {

class AdaptiveTest : public GpuTest {
protected:
    static RenderSettings settingsFor(const Scene& scene, uint32_t side, uint32_t samples,
                                      uint32_t seed, Sampler sampler = Sampler::Sobol) {
        RenderSettings settings = squareSettings(scene, side, seed);
        settings.samplesPerPixel = samples;
        settings.sampler = sampler;
        return settings;
    }

    template <typename AnySession>
    static JudgedPicture render(DeviceTracer& device, const RenderSettings& settings) {
        AnySession session(device.tracer(), settings, device.packed().maxRadiance);
        session.run({});
        EXPECT_NEAR(static_cast<double>(session.totals().samplesPerPixel), settings.samplesPerPixel,
                    0.05 * settings.samplesPerPixel);
        return judge(session.film());
    }
};

/// Relative error by the true deviations, less the truth's own.
double trueError(const JudgedPicture& picture, const JudgedPicture& truth) {
    const double square = 1.96 * 1.96 * trueSquare(picture, truth.luminances);
    return std::sqrt(std::max(0.0, square - std::pow(truth.estimate.relative, 2.0)));
}

/// All samples of a block.
std::vector<glm::vec4> renderBlock(BlockTracer& tracer, std::span<const uint8_t> isLeftOut) {
    tracer.beginBlock(0, isLeftOut);
    for (uint32_t tile = 0; tile < tracer.tileCount(); ++tile)
        while (tracer.renderTiles({tile, 1}, shared::kSamplesPerBlock).unfinishedPixels > 0)
            ;
    const std::span<const glm::vec4> block = tracer.readBlock();
    return {block.begin(), block.end()};
}

// What lacks no samples costs nothing, and what does gets those of a whole block.
TEST_F(AdaptiveTest, RendersTheTilesThatLackSamples) {
    const Scene scene = projectScene("scenes/cornell-box.json");
    RenderSettings settings = settingsFor(scene, 50, 0, 3); // whose last tiles reach beyond it
    DeviceTracer device(scene, settings);
    const std::vector<glm::vec4> whole = renderBlock(device.tracer(), {});
    EXPECT_EQ(device.tracer().tileCount(), 16u);
    std::vector<uint8_t> isLeftOut(whole.size(), 1);
    for (const size_t pixel : {20 * 50 + 31, 21 * 50 + 32, 49 * 50 + 49}) // in three tiles
        isLeftOut[pixel] = 0;
    const std::vector<glm::vec4> few = renderBlock(device.tracer(), isLeftOut);
    EXPECT_EQ(device.tracer().tileCount(), 3u);
    for (size_t i = 0; i < few.size(); ++i)
        EXPECT_EQ(few[i], isLeftOut[i] != 0 ? glm::vec4(0, 0, 0, 16) : whole[i]) << i;
    EXPECT_EQ(renderBlock(device.tracer(), {}), whole);
    EXPECT_EQ(device.tracer().tileCount(), 16u);
}

// Noise in a few places: at as many samples the error is smaller, and what is stated is true. The
// truth's own error is taken off; of 2048 samples it is less than half of a picture's.
TEST_F(AdaptiveTest, SpendsSamplesBetter) {
    std::vector<const char*> paths = {"scenes/dielectric.json"};
    if (isSlowRun())
        paths.push_back("scenes/depth-of-field.json");
    for (const char* path : paths) {
        SCOPED_TRACE(path);
        const Scene scene = projectScene(path);
        RenderSettings settings = settingsFor(scene, 32, quickOrFull(2048u, 8192u), 99);
        DeviceTracer truthDevice(scene, settings);
        const JudgedPicture truth = render<RenderSession>(truthDevice, settings);
        double stated = 0.0;
        double isTrue = 0.0;
        double even = 0.0;
        constexpr uint32_t kSeeds = 3;
        for (uint32_t seed = 0; seed < kSeeds; ++seed) {
            settings = settingsFor(scene, 32, 512, seed);
            DeviceTracer device(scene, settings);
            const JudgedPicture adaptive = render<AdaptiveSession>(device, settings);
            const JudgedPicture uniform = render<RenderSession>(device, settings);
            stated += adaptive.estimate.relative / kSeeds;
            isTrue += trueError(adaptive, truth) / kSeeds;
            even += trueError(uniform, truth) / kSeeds;
            EXPECT_TRUE(adaptive.estimate.isTrusted()) << *adaptive.estimate.doubt;
        }
        std::cout << path << ": " << isTrue << " (stated " << stated << "), uniform " << even
                  << "\n";
        EXPECT_NEAR(stated / isTrue, 1.0, 0.12);
        EXPECT_LT(isTrue, 0.85 * even);
    }
}
ALSO_SLOW(AdaptiveTest, SpendsSamplesBetter);

// 12 pictures of 512 samples: each against the mean of the others, which has an eleventh of its
// variance.
TEST_F(AdaptiveTest, PixelsLieWithinTheirIntervals) {
    constexpr uint32_t kPictures = 12;
    const Scene scene = projectScene("scenes/cornell-box.json");
    for (const Sampler sampler : {Sampler::Independent, Sampler::Sobol}) {
        SCOPED_TRACE(nameOf(sampler));
        const RenderSettings settings = settingsFor(scene, 16, 512, 300, sampler);
        SeededFilms films(scene, settings);
        std::vector<JudgedPicture> pictures;
        for (uint32_t i = 0; i < kPictures; ++i) {
            const AdaptiveFilm film = films.next<AdaptiveSession>();
            EXPECT_NEAR(static_cast<double>(film.samples()) / (16 * 16), 512.0, 0.05 * 512.0);
            pictures.push_back(judge(film));
        }
        Coverage coverage;
        for (const JudgedPicture& picture : pictures)
            coverage.add(picture, meanOfOthers(pictures, &picture), 1.0 / (kPictures - 1));
        std::cout << nameOf(sampler) << ": " << coverage.share() << "\n";
        RecordProperty(nameOf(sampler), std::to_string(coverage.share()));
        EXPECT_GT(coverage.all, 0.5 * kPictures * 256);
        EXPECT_GT(coverage.share(), 0.93);
        EXPECT_LT(coverage.share(), 0.97);
    }
}

} // namespace
} // namespace calotype::test
