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

std::vector<double> blockMeans(const TileMeans& means) {
    std::vector<double> values;
    for (size_t block = 0; block < means.blocks(); ++block)
        values.push_back(means.whole(block).x);
    return values;
}

} // namespace

Judgement judge(const Scene& scene, uint32_t side, size_t blocks,
                std::optional<LightChoice> choice) {
    RenderSettings settings = squareSettings(scene, side, kSeed);
    settings.transport.lightChoice = choice.value_or(settings.transport.lightChoice);
    DeviceTracer device(scene, settings);
    const auto ofDevice = blockMeans(renderTileMeans(device.tracer(), side, side, blocks));
    const reference::ReferenceTracer reference(scene, {side, side}, settings.maxBounces,
                                               settings.transport);
    ReferenceBlock referenceBlock(reference, settings, kThreads);
    const auto ofReference = blockMeans(renderTileMeans(referenceBlock, side, side, blocks));

    std::vector<double> differences;
    for (size_t block = 0; block < blocks; ++block)
        differences.push_back(ofDevice[block] - ofReference[block]);
    return {estimate(ofDevice), estimate(ofReference), estimate(differences)};
}

void expectJudgement(const Judgement& judgement, double bound) {
    const auto& [device, reference, difference] = judgement;
    EXPECT_NEAR(device.mean, reference.mean,
                bound * reference.mean + 5.0 * difference.standardError);
    std::cout << "device " << device.mean << ", reference " << reference.mean << " +- "
              << reference.standardError << ", relative difference "
              << difference.mean / reference.mean << " +- "
              << difference.standardError / reference.mean << "\n";
}

} // namespace calotype::test
