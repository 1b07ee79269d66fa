// How an adaptive session distributes samples: the samples that it requests from a fake tracer.
#include "render/adaptive_session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "film/error_estimate.h"
#include "math/luminance.h"
#include "support/slow_run.h"

namespace calotype::test {
namespace {

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 32;

/// Far enough from each other for no smoothing of the noise to join them.
bool isNoisy(size_t pixel) { return pixel % kWidth % 8 == 4 && pixel / kWidth % 8 == 4; }
constexpr size_t kNoisy = 4 * kWidth + 4;

/// Its samples are dim, or, one in `kOdds` times and in noisy pixels only, bright.
/// The random numbers of each half of the film have seeds of their own.
class RareTracer : public BlockTracer {
public:
    static constexpr uint64_t kOdds = 48;
    static constexpr float kBright = 48.0f;

    explicit RareTracer(std::array<uint64_t, 2> seeds, uint32_t pause = 16)
        : seeds_(seeds), pause_(pause) {}

    uint32_t tileCount() const override { return 1; }

    void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut) override {
        firstSample_ = firstSample;
        for (size_t i = 0; i < sums_.size(); ++i)
            sums_[i] = {0.0f, 0.0f, 0.0f, !isLeftOut.empty() && isLeftOut[i] ? 16.0f : 0.0f};
    }

    shared::RenderCounters renderTiles(TileRange, uint32_t sampleEnd) override {
        shared::RenderCounters counters{};
        for (size_t i = 0; i < sums_.size(); ++i) {
            const auto done = static_cast<uint32_t>(sums_[i].w);
            const uint32_t end = std::min(sampleEnd, done + pause_);
            for (uint32_t s = done; s < end; ++s, ++counters.paths)
                sums_[i] += glm::vec4(glm::vec3(sample(i, firstSample_ + s)), 1.0f);
            counters.unfinishedPixels += std::max(end, done) < sampleEnd ? 1 : 0;
        }
        return counters;
    }

    std::span<const glm::vec4> readBlock() override { return sums_; }

private:
    float sample(size_t pixel, uint32_t index) const {
        uint64_t x = (seeds_[index / 16 % 2] << 40) ^ (uint64_t{pixel} << 24) ^ index;
        for (int i = 0; i < 3; ++i) {
            x = (x ^ (x >> 31)) * 0x9e3779b97f4a7c15ull;
            x ^= x >> 29;
        }
        const float floor = 0.5f;
        if (!isNoisy(pixel))
            return floor + 1e-3f * static_cast<float>(x % 8);
        return x % kOdds == 0 ? floor + kBright : floor;
    }

    std::array<uint64_t, 2> seeds_;
    uint32_t pause_;
    uint32_t firstSample_ = 0;
    std::vector<glm::vec4> sums_ = std::vector<glm::vec4>(kWidth * kHeight);
};

RenderSettings settingsOf(uint32_t samples) {
    RenderSettings settings;
    settings.crop = {0, 0, kWidth, kHeight};
    settings.samplesPerPixel = samples;
    return settings;
}

std::vector<uint32_t> countsOf(const AdaptiveSession& session, uint32_t half) {
    const auto blocks = session.film().blocksOf(half);
    return {blocks.begin(), blocks.end()};
}

TEST(AdaptiveSessionTest, GivesSamplesToNoise) {
    RareTracer tracer({1, 2});
    AdaptiveSession session(tracer, settingsOf(1024), 64.0);
    EXPECT_EQ(session.run({}), RenderEnding::AllSamples);
    EXPECT_EQ(session.samplesInTheEnd(), 1024u);
    EXPECT_NEAR(static_cast<double>(session.totals().samplesPerPixel), 1024.0, 32.0);
    EXPECT_EQ(session.totals().paths, session.film().samples());
    for (uint32_t half = 0; half < 2; ++half) {
        const auto counts = countsOf(session, half);
        EXPECT_EQ(counts[0], 8u) << "the survey alone: 256 samples";
        EXPECT_GT(counts[kNoisy], 24u);
    }
}

// Which samples a half has never depends on what it found itself: that is why there is no bias.
TEST(AdaptiveSessionTest, EachHalfIsSteeredByTheOther) {
    const auto counts = [](std::array<uint64_t, 2> seeds, uint32_t half) {
        RareTracer tracer(seeds);
        AdaptiveSession session(tracer, settingsOf(2048), 64.0);
        session.run({});
        return countsOf(session, half);
    };
    EXPECT_EQ(counts({1, 2}, 0), counts({7, 2}, 0));
    EXPECT_EQ(counts({1, 2}, 1), counts({1, 7}, 1));
    EXPECT_NE(counts({1, 2}, 0), counts({1, 7}, 0));
    EXPECT_NE(counts({1, 2}, 1), counts({7, 2}, 1));
}

// Rare bright samples are what steering by one's own finds would lose: mean of many pictures.
TEST(AdaptiveSessionTest, HasNoBias) {
    constexpr uint32_t kPictures = 150;
    std::vector<double> means;
    for (uint32_t seed = 0; seed < kPictures; ++seed) {
        RareTracer tracer({2 * seed + 100, 2 * seed + 101});
        AdaptiveSession session(tracer, settingsOf(256), 64.0);
        session.run({});
        double sum = 0.0;
        const Image picture = session.picture();
        for (uint32_t i = 0; i < kWidth * kHeight; ++i)
            if (isNoisy(i))
                sum += picture.pixels[i].g;
        means.push_back(sum / (kWidth / 8 * kHeight / 8));
    }
    const double mean = std::accumulate(means.begin(), means.end(), 0.0) / kPictures;
    double variance = 0.0;
    for (const double m : means)
        variance += (m - mean) * (m - mean) / (kPictures * (kPictures - 1.0));
    const double truth = 0.5 + RareTracer::kBright / RareTracer::kOdds;
    EXPECT_LT(std::sqrt(variance), 0.02 * truth);
    EXPECT_NEAR(mean, truth, 3.3 * std::sqrt(variance)); // 1 in 1000
}

// Where light is rare, what one half finds gives the other more samples there, so that both find
// less alike: the spread within the halves does not show that. It is some tenth of the error.
TEST(AdaptiveSessionTest, StatesItsErrorAlmostWholeWhereLightIsRare) {
    for (const uint32_t samples : {256u, 1024u}) {
        if (samples > 256 && !isSlowRun())
            continue;
        constexpr uint32_t kPictures = 150;
        double stated = 0.0;
        double found = 0.0;
        for (uint32_t seed = 0; seed < kPictures; ++seed) {
            RareTracer tracer({2 * seed + 1000, 2 * seed + 1001});
            AdaptiveSession session(tracer, settingsOf(samples), 64.0);
            session.run({});
            stated += std::pow(session.error()->relative, 2.0) / kPictures;
            const Image picture = session.picture();
            double mean = 0.0;
            for (const glm::vec3& pixel : picture.pixels)
                mean += pixel.g / (kWidth * kHeight);
            double sum = 0.0;
            for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
                const double truth =
                    isNoisy(i) ? 0.5 + RareTracer::kBright / RareTracer::kOdds : 0.5;
                sum += relativeShare(std::pow(picture.pixels[i].g - truth, 2.0), truth, mean);
            }
            found += std::pow(relativeError(sum / (kWidth * kHeight)), 2.0) / kPictures;
        }
        const double ratio = std::sqrt(found / stated);
        std::cout << samples << " samples: " << ratio << " of the stated error\n";
        EXPECT_NEAR(ratio, 1.08, 0.04);
    }
}
ALSO_SLOW_TEST(AdaptiveSessionTest, StatesItsErrorAlmostWholeWhereLightIsRare);

TEST(AdaptiveSessionTest, DoesNotDependOnHowTheWorkIsCutUp) {
    RareTracer whole({1, 2});
    RareTracer paused({1, 2}, 3);
    AdaptiveSession a(whole, settingsOf(512), 64.0);
    AdaptiveSession b(paused, settingsOf(512), 64.0);
    a.run({});
    b.run({});
    EXPECT_EQ(countsOf(a, 0), countsOf(b, 0));
    EXPECT_TRUE(a.picture().pixels == b.picture().pixels);
}

TEST(AdaptiveSessionTest, EndsByItsGoals) {
    RareTracer tracer({1, 2});
    AdaptiveSession aimed(tracer, settingsOf(1u << 20), 64.0);
    RenderGoal goal;
    goal.targetError = 0.06;
    EXPECT_EQ(aimed.run({}, 0, goal), RenderEnding::TargetError);
    EXPECT_LE(aimed.error()->upperBound(), 0.06);
    EXPECT_GT(aimed.totals().samplesPerPixel, 128u);
    // The bound falls at least as slowly as 1 / sqrt(samples), up to its own noise.
    EXPECT_GT(aimed.error()->upperBound(), 0.06 / std::sqrt(1.3));
    AdaptiveSession late(tracer, settingsOf(1u << 20), 64.0);
    RenderGoal deadline;
    deadline.deadline = std::chrono::steady_clock::now();
    EXPECT_EQ(late.run({}, 0, deadline), RenderEnding::Deadline);
    EXPECT_GE(late.totals().paths, kWidth * kHeight) << "one sample in every pixel";
    AdaptiveSession stopped(tracer, settingsOf(1024), 64.0);
    RenderObserver observer;
    observer.shouldStop = [&] { return stopped.totals().paths > 200 * kWidth * kHeight; };
    EXPECT_EQ(stopped.run(observer), RenderEnding::Stopped);
    EXPECT_GT(stopped.film().samples(), 150 * kWidth * kHeight);
    for (const glm::vec3& pixel : stopped.picture().pixels)
        EXPECT_GE(pixel.g, 0.49f);
}

// Fewer samples than a first round: whole blocks of both halves.
TEST(AdaptiveSessionTest, RoundsUpToWholeBlocks) {
    for (const auto& [asked, given] : {std::pair{1u, 32u}, {40u, 64u}, {128u, 128u}}) {
        RareTracer tracer({1, 2});
        AdaptiveSession session(tracer, settingsOf(asked), 64.0);
        EXPECT_EQ(session.run({}), RenderEnding::AllSamples);
        EXPECT_EQ(session.samplesInTheEnd(), given);
        EXPECT_EQ(session.totals().samplesPerPixel, given);
    }
}

} // namespace
} // namespace calotype::test
