// How a session divides a render into blocks, passes and dispatches: the samples that it requests
// from a fake tracer.
#include "render/render_session.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace calotype::test {
namespace {

/// Its sample of absolute index i is the radiance i + 1, on each of its 3 pixels. Every other call
/// it pauses after one sample, as a device does that has to come back in time.
class CountingTracer : public BlockTracer {
public:
    uint32_t tileCount() const override { return 1; }

    void beginBlock(uint32_t firstSample, std::span<const uint8_t>) override {
        firstSample_ = firstSample;
        std::ranges::fill(sums_, glm::vec4(0.0f));
    }

    shared::RenderCounters renderTiles(TileRange, uint32_t sampleEnd) override {
        shared::RenderCounters counters{};
        const auto done = static_cast<uint32_t>(sums_[0].w);
        pauses_ = !pauses_;
        const uint32_t end = pauses_ ? std::min(done + 1, sampleEnd) : sampleEnd;
        for (glm::vec4& sum : sums_) {
            for (uint32_t i = done; i < end; ++i) {
                sum += glm::vec4(glm::vec3(static_cast<float>(firstSample_ + i + 1)), 1.0f);
                ++counters.paths;
            }
            counters.unfinishedPixels += end < sampleEnd ? 1 : 0;
        }
        return counters;
    }

    std::span<const glm::vec4> readBlock() override { return sums_; }

private:
    std::vector<glm::vec4> sums_ = std::vector<glm::vec4>(3);
    uint32_t firstSample_ = 0;
    bool pauses_ = false;
};

// Whole blocks or a part of one at the end, in passes of any size: every index from 0 on, once.
TEST(RenderSessionTest, TakesEverySampleIndexOnce) {
    for (const uint32_t samples : {1u, 7u, 16u, 17u, 40u, 48u})
        for (const uint32_t passSamples : {0u, 1u, 3u, 16u, 100u}) {
            SCOPED_TRACE(testing::Message() << samples << " in passes of " << passSamples);
            RenderSettings settings;
            settings.samplesPerPixel = samples;
            settings.crop = {0, 0, 3, 1};
            CountingTracer tracer;
            RenderSession session(tracer, settings, 64.0);
            EXPECT_EQ(session.run({}, passSamples), RenderEnding::AllSamples);
            EXPECT_EQ(session.samplesInTheEnd(), samples);
            EXPECT_EQ(session.totals().paths, 3 * samples);
            const float mean = 0.5f * static_cast<float>(samples + 1); // of 1 to `samples`
            for (const glm::vec3& pixel : session.picture().pixels)
                EXPECT_FLOAT_EQ(pixel.x, mean);
        }
}

RenderSettings settingsFor(uint32_t firstSample, uint32_t samples) {
    RenderSettings settings;
    settings.firstSample = firstSample;
    settings.samplesPerPixel = samples;
    settings.crop = {0, 0, 3, 1};
    return settings;
}

Film filmOf(uint32_t firstSample, uint32_t samples) {
    CountingTracer tracer;
    RenderSession session(tracer, settingsFor(firstSample, samples), 64.0);
    session.run({});
    return session.film();
}

// Whatever of the samples a film holds before, it holds them all, once, in the end.
TEST(RenderSessionTest, GoesOnWithWhatAFilmLacks) {
    const Film whole = filmOf(0, 160);
    for (const auto& [first, count] :
         {std::pair{0u, 16u}, {0u, 48u}, {32u, 64u}, {144u, 16u}, {0u, 160u}, {64u, 480u}}) {
        SCOPED_TRACE(testing::Message() << first << " and " << count << " more");
        CountingTracer tracer;
        RenderSession session(tracer, settingsFor(0, 160), filmOf(first, count));
        const uint32_t outside = first + count > 160 ? first + count - 160 : 0;
        EXPECT_EQ(session.samplesInTheEnd(), 160 + outside);
        EXPECT_EQ(session.run({}), RenderEnding::AllSamples);
        EXPECT_EQ(session.totals().paths, 3 * (160 - (count - outside)));
        EXPECT_EQ(session.totals().samplesPerPixel, 160 + outside);
        EXPECT_EQ(session.film().sums() == whole.sums(), outside == 0);
    }
}

TEST(RenderSessionTest, RendersARangeOfSamples) {
    Film joined = filmOf(96, 64);
    EXPECT_EQ(joined.blocks().ranges().front(), (BlockRange{6, 10}));
    joined.add(filmOf(0, 96));
    EXPECT_TRUE(joined.sums() == filmOf(0, 160).sums());
}

// A block that was begun shows in the picture, never in the film.
TEST(RenderSessionTest, StopsWithinABlock) {
    CountingTracer tracer;
    RenderSession session(tracer, settingsFor(0, 64), 64.0);
    RenderObserver observer;
    observer.shouldStop = [&] { return session.totals().paths > 3 * 20; };
    EXPECT_EQ(session.run(observer), RenderEnding::Stopped);
    EXPECT_TRUE(session.film().sums() == filmOf(0, 16).sums());
    EXPECT_GT(session.picture().pixels[0].x, session.film().picture().pixels[0].x);
}

TEST(RenderSessionTest, DeadlineLeavesTimeForOneSample) {
    CountingTracer tracer;
    RenderSession session(tracer, settingsFor(0, 1u << 20), 64.0);
    RenderGoal goal;
    goal.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    EXPECT_EQ(session.run({}, 0, goal), RenderEnding::Deadline);
    EXPECT_GE(session.totals().samplesPerPixel, 1u);
    EXPECT_LE(session.totals().samplesPerPixel, 2u);
}

/// Like CountingTracer, but a pixel's mean over block b is 1 + noise / 2^(b / 8), of either sign:
/// the error halves, and more, with each 128 samples.
class SettlingTracer : public CountingTracer {
public:
    explicit SettlingTracer(float noise) : noise_(noise) {}

    void beginBlock(uint32_t firstSample, std::span<const uint8_t>) override {
        CountingTracer::beginBlock(firstSample, {});
        block_ = firstSample / shared::kSamplesPerBlock;
    }

    std::span<const glm::vec4> readBlock() override {
        const std::span<const glm::vec4> counted = CountingTracer::readBlock();
        const float sign = block_ % 2 == 0 ? 1.0f : -1.0f;
        const float mean = 1.0f + sign * std::ldexp(noise_, -static_cast<int>(block_ / 8));
        sums_.assign(counted.size(), glm::vec4(glm::vec3(mean * counted[0].w), counted[0].w));
        return sums_;
    }

private:
    float noise_;
    uint32_t block_ = 0;
    std::vector<glm::vec4> sums_;
};

// The bound on the error is looked at eight times while the samples double, and nowhere else.
TEST(RenderSessionTest, EndsAtALookThatIsGoodEnough) {
    for (const double target : {0.5, 0.1, 0.02}) {
        SettlingTracer tracer(0.5f);
        RenderSession session(tracer, settingsFor(0, 1u << 16), 64.0);
        std::map<uint64_t, double> bounds;
        RenderObserver observer;
        observer.onBlock = [&] {
            if (const auto error = estimateError(session.film()))
                bounds[session.film().samplesPerPixel()] = error->upperBound();
        };
        RenderGoal goal;
        goal.targetError = target;
        EXPECT_EQ(session.run(observer, 0, goal), RenderEnding::TargetError);
        const auto isLook = [](uint64_t blocks) { // 8, 9, ... 16, 18, ... 32, 36, ...
            while (blocks >= 16)
                if (blocks % 2 != 0)
                    return false;
                else
                    blocks /= 2;
            return blocks >= 8;
        };
        uint64_t expected = 128;
        while (!isLook(expected / 16) || bounds.at(expected) > target)
            expected += 16;
        EXPECT_EQ(session.totals().samplesPerPixel, expected) << target;
        EXPECT_EQ(session.totals().error->relative, session.error()->relative);
        // A film that is good enough is left as it is.
        RenderSession again(tracer, settingsFor(0, 1u << 16), session.film());
        EXPECT_EQ(again.run({}, 0, goal), RenderEnding::TargetError);
        EXPECT_EQ(again.totals().paths, 0u);
    }
}

// An error from elsewhere takes the place of the film's own, which here is good enough at once.
TEST(RenderSessionTest, EndsByTheErrorAfterDenoising) {
    SettlingTracer tracer(0.0f);
    RenderSession session(tracer, settingsFor(0, 1u << 16), 64.0);
    std::vector<uint64_t> looks;
    RenderGoal goal;
    goal.targetError = 0.05;
    goal.denoisedError = [&](const FilmView& film) -> std::optional<DenoisedError> {
        looks.push_back(film.samplesPerPixel());
        if (looks.size() == 2)
            return std::nullopt; // not known
        return DenoisedError{0.01, 0.02, looks.size() < 4 ? 0.0501 : 0.05};
    };
    EXPECT_EQ(session.run({}, 0, goal), RenderEnding::TargetError);
    EXPECT_EQ(looks, (std::vector<uint64_t>{128, 144, 160, 176}));
    EXPECT_EQ(session.totals().samplesPerPixel, 176u);
    EXPECT_EQ(session.totals().denoisedSamples, 176u);
    EXPECT_EQ(session.totals().denoised->upperBound, 0.05);
}

} // namespace
} // namespace calotype::test
