#include "engine/render_plan.h"

#include <gtest/gtest.h>

namespace calotype {
namespace {

RenderTotals after(uint64_t samples) {
    RenderTotals totals;
    totals.samplesPerPixel = samples;
    totals.paths = 10 * samples;
    return totals;
}

TEST(RenderPlanTest, IsDoneByTheNearestEnd) {
    RenderPlan plan{.pixels = 10, .samplesPerPixel = 400};
    EXPECT_EQ(shareDone(plan, after(100), 5.0), 0.25);
    plan.seconds = 8.0;
    EXPECT_EQ(shareDone(plan, after(100), 5.0), 0.625);
    EXPECT_EQ(shareDone(plan, after(100), 9.0), 1.0);
}

// A quarter of the error needs 16 times the samples, at a look: 2048 of 128; of 1.1 times the
// target 155, so 160.
TEST(RenderPlanTest, ExtrapolatesTheError) {
    RenderPlan plan{.pixels = 10, .targetError = 0.1};
    EXPECT_EQ(shareDone(plan, after(128), 5.0), 0.0);
    RenderTotals totals = after(128);
    totals.error = ErrorEstimate{.relative = 0.4};
    EXPECT_EQ(shareDone(plan, totals, 5.0), 128.0 / 2048.0);
    totals.error->relative = 0.11;
    EXPECT_EQ(shareDone(plan, totals, 5.0), 128.0 / 160.0);
}

TEST(RenderPlanTest, ExtrapolatesTheErrorAfterDenoising) {
    const RenderPlan plan{.pixels = 10, .targetError = 0.1, .targetsDenoised = true};
    RenderTotals totals = after(256);
    totals.error = ErrorEstimate{.relative = 0.4};
    EXPECT_EQ(shareDone(plan, totals, 5.0), 0.0);
    totals.denoised = DenoisedError{0.1, 0.15, 0.2};
    totals.denoisedSamples = 128;
    EXPECT_EQ(shareDone(plan, totals, 5.0), 256.0 / 512.0);
}

} // namespace
} // namespace calotype
