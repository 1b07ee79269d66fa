#include "extremes/judgement.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "reference/reference_tracer.h"
#include "render/reference_block.h"
#include "shared/limits.h"
#include "support/device_tracer.h"

namespace calotype::test {
namespace {

constexpr uint32_t kThreads = 2;
constexpr uint32_t kSeed = 11;

/// Keeps count of what a tracer reports.
class CountingTracer : public BlockTracer {
public:
    explicit CountingTracer(BlockTracer& tracer) : tracer_(tracer) {}

    uint32_t tileCount() const override { return tracer_.tileCount(); }
    void beginBlock(uint32_t firstSample) override { tracer_.beginBlock(firstSample); }
    std::span<const glm::vec4> readBlock() override { return tracer_.readBlock(); }

    gpu::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) override {
        const gpu::RenderCounters counters = tracer_.renderTiles(tiles, sampleEnd);
        counted_.paths += counters.paths;
        counted_.nonFiniteSamples += counters.nonFiniteSamples;
        counted_.cutPaths += counters.cutPaths;
        return counters;
    }

    const Counted& counted() const { return counted_; }

private:
    BlockTracer& tracer_;
    Counted counted_;
};

std::vector<double> blockMeans(const TileMeans& means) {
    std::vector<double> values;
    for (size_t block = 0; block < means.blocks(); ++block)
        values.push_back(means.whole(block).x);
    return values;
}

} // namespace

Judgement judge(const Scene& scene, uint32_t side, size_t blocks) {
    RenderSettings settings;
    settings.width = side;
    settings.height = side;
    settings.crop = {0, 0, side, side};
    settings.maxBounces = scene.render.maxBounces;
    settings.seed = kSeed;

    DeviceTracer device(scene, settings);
    CountingTracer counting(device.tracer());
    const auto ofDevice = blockMeans(renderTileMeans(counting, side, side, blocks));
    const reference::ReferenceTracer reference(scene, {side, side}, settings.maxBounces);
    ReferenceBlock referenceBlock(reference, settings, kThreads);
    const auto ofReference = blockMeans(renderTileMeans(referenceBlock, side, side, blocks));

    std::vector<double> differences;
    for (size_t block = 0; block < blocks; ++block)
        differences.push_back(ofDevice[block] - ofReference[block]);
    return {estimate(ofDevice), estimate(ofReference), estimate(differences), counting.counted()};
}

void expectJudgement(const Judgement& judgement, double bound) {
    const auto& [device, reference, difference, counted] = judgement;
    EXPECT_EQ(counted.nonFiniteSamples, 0u);
    EXPECT_EQ(counted.cutPaths, 0u);
    EXPECT_NEAR(device.mean, reference.mean,
                bound * reference.mean + 5.0 * difference.standardError);
    std::cout << "device " << device.mean << ", reference " << reference.mean << " +- "
              << reference.standardError << ", relative difference "
              << difference.mean / reference.mean << " +- "
              << difference.standardError / reference.mean << "\n";
}

} // namespace calotype::test
