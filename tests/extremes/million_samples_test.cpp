// Very many samples in one film: no drift, no stagnation, nothing lost.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "film/film.h"
#include "shared/limits.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/scene_builder.h"
#include "support/statistics.h"

namespace calotype::test {
namespace {

constexpr uint32_t kMillion = 1u << 20;

/// Inside a sphere of albedo 1/2 that glows, seen along paths of at most 20 events.
Scene furnace() {
    SceneBuilder builder;
    builder.material(0.5, 0.5);
    builder.add(makeShape(Sphere{{}, 1.0}, 0));
    builder.scene().camera.position = {0.1, 0.2, 0.15};
    builder.scene().render.maxBounces = 20;
    return builder.scene();
}

/// One pixel's film, and its blocks as they came.
struct LongRender {
    Film film;
    std::vector<double> blockMeans; ///< of the first channel
};

LongRender render(const Scene& scene, uint32_t samples) {
    RenderSettings settings;
    settings.width = settings.height = 1;
    settings.crop = {0, 0, 1, 1};
    settings.maxBounces = scene.render.maxBounces;
    settings.sampler = Sampler::Independent;
    DeviceTracer device(scene, settings);
    LongRender result{Film(1, 1, filmUnit(device.packed().maxRadiance)), {}};
    for (uint32_t first = 0; first < samples; first += shared::kSamplesPerBlock) {
        device.tracer().beginBlock(first);
        shared::RenderCounters counters{};
        do {
            counters = device.tracer().renderTiles({0, 1}, shared::kSamplesPerBlock);
            EXPECT_EQ(counters.nonFiniteSamples + counters.cutPaths, 0u);
        } while (counters.unfinishedPixels > 0);
        const std::span<const glm::vec4> block = device.tracer().readBlock();
        result.film.addBlock(first / shared::kSamplesPerBlock, block);
        result.blockMeans.push_back(double{block[0].x} / shared::kSamplesPerBlock);
    }
    return result;
}

// The film is the blocks' sum, to the rounding of the one float that the picture holds; and the
// blocks' mean is the answer in closed form, within four standard errors of all of them together.
void expectNoDrift(uint32_t samples) {
    const LongRender long_ = render(furnace(), samples);
    EXPECT_EQ(long_.film.samplesPerPixel(), samples);
    EXPECT_EQ(long_.film.losses().lostPixels(), 0u);
    const Estimate mean = estimate(long_.blockMeans);
    const double shown = double{long_.film.picture().at(0, 0).x};
    EXPECT_NEAR(shown, mean.mean, 0x1p-24 * mean.mean);
    const double expected = 1.0 - std::pow(0.5, 21);
    EXPECT_NEAR(mean.mean, expected, 4.0 * mean.standardError);
    std::cout << samples << " samples: " << mean.mean - expected << " +- " << mean.standardError
              << "\n";
}

// A room that is black and glows is of one radiance in every sample. A block of 16 rounds its sum,
// always to the same float; a million of them are that float to the last bit.
void expectConstant(uint32_t samples) {
    Scene scene = furnace();
    scene.materials[0].color = glm::dvec3(0.0);
    scene.materials[0].emission = glm::dvec3(0.1, 0.7, 3.0);
    EXPECT_EQ(render(scene, samples).film.picture().pixels,
              render(scene, shared::kSamplesPerBlock).film.picture().pixels);
}

class MillionSamplesTest : public GpuTest {};
class SlowMillionSamplesTest : public GpuTest {};

TEST_F(MillionSamplesTest, FurnaceDoesNotDriftOverThousands) { expectNoDrift(kMillion / 64); }
TEST_F(MillionSamplesTest, ConstantStaysConstantOverThousands) { expectConstant(kMillion / 64); }
TEST_F(SlowMillionSamplesTest, FurnaceDoesNotDrift) { expectNoDrift(kMillion); }
TEST_F(SlowMillionSamplesTest, ConstantStaysConstant) { expectConstant(kMillion); }

} // namespace
} // namespace calotype::test
