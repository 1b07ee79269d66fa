#include <cmath>
#include <numbers>

#include <glm/vec2.hpp>

#include "kernels/sin_cos_two_pi.spv.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

class SinCosTwoPiTest : public GpuTest {};

TEST_F(SinCosTwoPiTest, ErrsByLessThanItStates) {
    // One number in 16 of all that unitFloats can give, with both ends.
    std::vector<float> turns;
    for (uint32_t i = 0; i <= 1u << 20; ++i)
        turns.push_back(static_cast<float>(i) * 0x1p-20f);
    turns.push_back(1.0f - 0x1p-24f);
    turns.push_back(0x1p-24f);
    const auto results = runKernel<glm::vec2>(kSinCosTwoPiSpirv, turns);
    double worst = 0.0;
    for (size_t i = 0; i < turns.size(); ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(turns[i]);
        worst = std::max({worst, std::abs(std::sin(angle) - static_cast<double>(results[i].x)),
                          std::abs(std::cos(angle) - static_cast<double>(results[i].y))});
    }
    RecordProperty("worstTimes1e9", std::to_string(worst * 1e9));
    EXPECT_LT(worst, 1.2e-7);
}

TEST_F(SinCosTwoPiTest, SineOfASmallAngleIsRelativelyPrecise) {
    std::vector<float> turns;
    for (float u = 0x1p-100f; u < 0.1f; u *= 1.0173f)
        turns.push_back(u);
    const auto results = runKernel<glm::vec2>(kSinCosTwoPiSpirv, turns);
    double worst = 0.0;
    for (size_t i = 0; i < turns.size(); ++i) {
        const double wanted = std::sin(2.0 * std::numbers::pi * static_cast<double>(turns[i]));
        worst = std::max(worst, std::abs(static_cast<double>(results[i].x) / wanted - 1.0));
    }
    EXPECT_LT(worst, 4.0 * 0x1p-23);
}

TEST_F(SinCosTwoPiTest, IsExactAtQuarterTurns) {
    const auto results =
        runKernel<glm::vec2>(kSinCosTwoPiSpirv, std::vector<float>{0.0f, 0.25f, 0.5f, 0.75f, 1.0f});
    const std::vector<glm::vec2> expected = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}};
    EXPECT_EQ(results, expected);
}

} // namespace
} // namespace calotype::test
