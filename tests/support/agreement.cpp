#include "support/agreement.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

#include "base/check.h"
#include "shared/limits.h"
#include "support/statistics.h"

namespace calotype::test {
namespace {

constexpr uint32_t kJudgedTile = 8; ///< pixels on a side

std::vector<double> channelOf(const TileMeans& means, size_t tile, int channel) {
    std::vector<double> values;
    for (size_t block = 0; block < means.blocks(); ++block)
        values.push_back(means.at(block, tile)[channel]);
    return values;
}

std::vector<double> wholeChannelOf(const TileMeans& means, int channel) {
    std::vector<double> values;
    for (size_t block = 0; block < means.blocks(); ++block)
        values.push_back(means.whole(block)[channel]);
    return values;
}

/// The normal deviate that is as unlikely as Student's t with n degrees of freedom (Wallace 1959,
/// "Bounds on Normal Approximations to Student's and the Chi-Square Distributions").
double normalDeviate(double t, double n) {
    const double z = std::sqrt(n * std::log1p(t * t / n)) * (8.0 * n + 1.0) / (8.0 * n + 3.0);
    return std::copysign(z, t);
}

/// Welch's test of two samples of one size. Where nothing varies, as in a plain background, there
/// still is the rounding of the device's sums: sixteen additions of single precision.
double welchZ(const std::vector<double>& a, const std::vector<double>& b) {
    const Estimate ofA = estimate(a);
    const Estimate ofB = estimate(b);
    const double rounding = 16.0 * 0x1p-24 * std::abs(ofB.mean);
    const double variance = ofA.standardError * ofA.standardError +
                            ofB.standardError * ofB.standardError + rounding * rounding;
    if (variance == 0.0)
        return ofA.mean == ofB.mean ? 0.0 : INFINITY;
    const double n = static_cast<double>(a.size()) - 1.0;
    const double squares = std::pow(ofA.standardError, 4.0) + std::pow(ofB.standardError, 4.0);
    constexpr double kAsGoodAsNormal = 1e9; // degrees of freedom
    const double degreesOfFreedom =
        squares > 0.0 ? std::min(n * variance * variance / squares, kAsGoodAsNormal)
                      : kAsGoodAsNormal;
    return normalDeviate((ofA.mean - ofB.mean) / std::sqrt(variance), degreesOfFreedom);
}

void renderWholeBlock(BlockTracer& tracer) {
    uint32_t done = 0;
    while (done < tracer.tileCount()) {
        const uint32_t count = std::min(tracer.tileCount() - done, 64u);
        const shared::RenderCounters counters =
            tracer.renderTiles({done, count}, shared::kSamplesPerBlock);
        EXPECT_EQ(counters.nonFiniteSamples, 0u);
        EXPECT_EQ(counters.cutPaths, 0u);
        done += counters.unfinishedPixels == 0 ? count : 0;
    }
}

std::vector<glm::dvec3> firstSamples(BlockTracer& tracer) {
    tracer.beginBlock(0);
    while (tracer.renderTiles({0, tracer.tileCount()}, 1).unfinishedPixels > 0) {
    }
    const std::span<const glm::vec4> sums = tracer.readBlock();
    return {sums.begin(), sums.end()};
}

bool differs(const glm::dvec3& found, const glm::dvec3& expected, const glm::dvec3& mean) {
    return !glm::all(
        glm::lessThanEqual(glm::abs(found - expected), 1e-3 * (glm::abs(expected) + mean)));
}

} // namespace

glm::dvec3 TileMeans::whole(size_t block) const {
    glm::dvec3 sum(0.0);
    for (size_t tile = 0; tile < tiles_; ++tile)
        sum += at(block, tile);
    return sum / static_cast<double>(tiles_);
}

TileMeans renderTileMeans(BlockTracer& tracer, uint32_t width, uint32_t height, size_t blocks,
                          size_t first) {
    CALOTYPE_CHECK_EQ(width % kJudgedTile, 0u);
    CALOTYPE_CHECK_EQ(height % kJudgedTile, 0u);
    const uint32_t tilesAcross = width / kJudgedTile;
    TileMeans means(size_t{tilesAcross} * (height / kJudgedTile), blocks);
    constexpr double kShare = 1.0 / (kJudgedTile * kJudgedTile * shared::kSamplesPerBlock);
    for (size_t block = 0; block < blocks; ++block) {
        tracer.beginBlock(static_cast<uint32_t>((first + block) * shared::kSamplesPerBlock));
        renderWholeBlock(tracer);
        const std::span<const glm::vec4> sums = tracer.readBlock();
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                const size_t tile = y / kJudgedTile * tilesAcross + x / kJudgedTile;
                means.at(block, tile) += kShare * glm::dvec3(sums[size_t{y} * width + x]);
            }
    }
    return means;
}

Agreement compareIndependent(const TileMeans& a, const TileMeans& b) {
    Agreement result;
    result.tiles = a.tiles();
    for (int channel = 0; channel < 3; ++channel) {
        result.wholeZ[channel] = welchZ(wholeChannelOf(a, channel), wholeChannelOf(b, channel));
        for (size_t tile = 0; tile < a.tiles(); ++tile) {
            const double z = welchZ(channelOf(a, tile, channel), channelOf(b, tile, channel));
            result.tileChiSquare[channel] += z * z;
            result.greatestTileZ = std::max(result.greatestTileZ, std::abs(z));
        }
    }
    return result;
}

PairedDifference comparePaired(const TileMeans& a, const TileMeans& b) {
    PairedDifference result;
    for (int channel = 0; channel < 3; ++channel) {
        const std::vector<double> ofA = wholeChannelOf(a, channel);
        const std::vector<double> ofB = wholeChannelOf(b, channel);
        std::vector<double> differences;
        for (size_t block = 0; block < ofA.size(); ++block)
            differences.push_back(ofA[block] - ofB[block]);
        const Estimate difference = estimate(differences);
        const double mean = estimate(ofB).mean;
        EXPECT_GT(mean, 0.0) << "channel " << channel;
        result.relative[channel] = difference.mean / mean;
        result.standardError[channel] = difference.standardError / mean;
    }
    return result;
}

double differingShare(BlockTracer& device, BlockTracer& reference) {
    return differingShare(firstSamples(device), firstSamples(reference));
}

double differingShare(const std::vector<glm::dvec3>& found,
                      const std::vector<glm::dvec3>& expected) {
    glm::dvec3 mean(0.0);
    for (const glm::dvec3& sample : expected)
        mean += sample / static_cast<double>(expected.size());
    size_t differing = 0;
    for (size_t i = 0; i < expected.size(); ++i)
        differing += differs(found[i], expected[i], mean) ? 1 : 0;
    return static_cast<double>(differing) / static_cast<double>(expected.size());
}

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

double normalLimit(size_t count) {
    // P(|Z| > z) for large z is erfc(z / sqrt 2); `count` of them together, at most count times
    // that.
    const double chance = 1e-4 / static_cast<double>(count);
    double low = 0.0;
    double high = 40.0;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > chance ? low : high) = middle;
    }
    return high;
}

} // namespace calotype::test
