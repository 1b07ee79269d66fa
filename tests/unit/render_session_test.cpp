// How a session divides a render into blocks, passes and dispatches: judged by the samples that a
// tracer is asked for.
#include "render/render_session.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace calotype::test {
namespace {

/// Its sample of absolute index i is the radiance i + 1, on each of its 3 pixels. Every other call
/// it pauses after one sample, as a device does that has to come back in time.
class CountingTracer : public BlockTracer {
public:
    uint32_t tileCount() const override { return 1; }

    void beginBlock(uint32_t firstSample) override {
        firstSample_ = firstSample;
        std::ranges::fill(sums_, glm::vec4(0.0f));
    }

    gpu::RenderCounters renderTiles(TileRange, uint32_t sampleEnd) override {
        gpu::RenderCounters counters{};
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
TEST(RenderSession, TakesEverySampleIndexOnce) {
    for (const uint32_t samples : {1u, 7u, 16u, 17u, 40u, 48u})
        for (const uint32_t passSamples : {0u, 1u, 3u, 16u, 100u}) {
            SCOPED_TRACE(testing::Message() << samples << " in passes of " << passSamples);
            RenderSettings settings;
            settings.samplesPerPixel = samples;
            settings.crop = {0, 0, 3, 1};
            CountingTracer tracer;
            RenderSession session(tracer, settings, 64.0);
            EXPECT_TRUE(session.run({}, passSamples));
            EXPECT_EQ(session.totals().paths, 3 * samples);
            const float mean = 0.5f * static_cast<float>(samples + 1); // of 1 to `samples`
            for (const glm::vec3& pixel : session.picture().pixels)
                EXPECT_FLOAT_EQ(pixel.x, mean);
        }
}

} // namespace
} // namespace calotype::test
