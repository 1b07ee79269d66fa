#include "extremes/picture_agreement.h"

#include <iostream>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "reference/reference_tracer.h"
#include "render/reference_block.h"
#include "support/chi_square.h"
#include "support/device_tracer.h"

namespace calotype::test {
namespace {

constexpr uint32_t kThreads = 2;
constexpr uint32_t kSeed = 7;

} // namespace

PictureAgreement agreementWithReference(const Scene& scene, const Scene& expected, uint32_t side,
                                        size_t blocks) {
    const RenderSettings settings = squareSettings(scene, side, kSeed);
    const reference::ReferenceTracer reference(expected, {side, side}, settings.maxBounces);
    ReferenceBlock judge(reference, settings, kThreads);
    DeviceTracer device(scene, settings);
    PictureAgreement result;
    result.differingShare = differingShare(device.tracer(), judge);
    const TileMeans expectedMeans = renderTileMeans(judge, side, side, blocks);
    result.paired =
        comparePaired(renderTileMeans(device.tracer(), side, side, blocks), expectedMeans);
    // Later samples are independent of those before them.
    result.independent = compareIndependent(
        renderTileMeans(device.tracer(), side, side, blocks, blocks), expectedMeans);
    for (size_t block = 0; block < blocks; ++block)
        result.meanRadiance += expectedMeans.whole(block) / static_cast<double>(blocks);
    return result;
}

void expectAgreement(const PictureAgreement& agreement, double bound, double mostDiffering) {
    const Agreement& independent = agreement.independent;
    EXPECT_LE(agreement.differingShare, mostDiffering);
    EXPECT_LT(independent.greatestTileZ, normalLimit(3 * independent.tiles));
    for (int channel = 0; channel < 3; ++channel) {
        SCOPED_TRACE(channel);
        EXPECT_GT(agreement.meanRadiance[channel], 0.01); // not two black pictures
        EXPECT_LE(std::abs(agreement.paired.relative[channel]),
                  bound + 5.0 * agreement.paired.standardError[channel]);
        EXPECT_LT(std::abs(independent.wholeZ[channel]), normalLimit(3));
        EXPECT_LT(independent.tileChiSquare[channel], chiSquareLimit(independent.tiles));
    }
    std::cout << "paired difference " << largest(glm::abs(agreement.paired.relative)) << " +- "
              << largest(agreement.paired.standardError) << ", pixels that differ "
              << 100.0 * agreement.differingShare << " %, |z| of the picture "
              << largest(glm::abs(independent.wholeZ)) << ", of its tiles up to "
              << independent.greatestTileZ << "\n";
}

} // namespace calotype::test
