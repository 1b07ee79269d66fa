#include <cmath>
#include <numbers>

#include <glm/vec2.hpp>

#include "kernels/angle_in_turns.spv.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

class AngleInTurnsTest : public GpuTest {};

TEST_F(AngleInTurnsTest, ErrsByLessThanItStatesAroundTheCircle) {
    RandomNumbers random(121);
    std::vector<glm::vec2> points;
    for (uint32_t i = 0; i < 1u << 18; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / (1u << 18);
        const double radius = random.powerOfTen(-15.0, 15.0);
        points.push_back(glm::vec2(radius * std::cos(angle), radius * std::sin(angle)));
    }
    const auto turns = runKernel<float>(kAngleInTurnsSpirv, points);
    double worst = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 p(points[i]);
        const double wanted = std::atan2(p.y, p.x) / (2.0 * std::numbers::pi);
        const double error = turns[i] - wanted;
        worst = std::max(worst, std::abs(error - std::round(error)));
        ASSERT_GE(turns[i], 0.0f);
        ASSERT_LT(turns[i], 1.0f);
    }
    RecordProperty("worstTimes1e9", std::to_string(worst * 1e9));
    EXPECT_LT(worst, 1e-7);
}

// Solid angles of small triangles are such angles.
TEST_F(AngleInTurnsTest, IsRelativelyPreciseNextToTheXAxis) {
    RandomNumbers random(122);
    std::vector<glm::vec2> points;
    for (uint32_t i = 0; i < 1u << 16; ++i) {
        const double radius = random.powerOfTen(-3.0, 3.0);
        points.push_back(glm::vec2(radius, radius * random.powerOfTen(-25.0, -1.0)));
    }
    const auto turns = runKernel<float>(kAngleInTurnsSpirv, points);
    double worst = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 p(points[i]);
        const double wanted = std::atan2(p.y, p.x) / (2.0 * std::numbers::pi);
        worst = std::max(worst, std::abs(turns[i] / wanted - 1.0));
    }
    RecordProperty("worstTimes1e9", std::to_string(worst * 1e9));
    EXPECT_LT(worst, 4.0 * 0x1p-23);
}

TEST_F(AngleInTurnsTest, IsExactOnTheAxesWhateverTheSignOfZero) {
    const std::vector<glm::vec2> points = {
        {1.0f, 0.0f},  {1.0f, -0.0f},  {0.0f, 1.0f}, {-0.0f, 1.0f}, {-1.0f, 0.0f}, {-1.0f, -0.0f},
        {0.0f, -1.0f}, {-0.0f, -1.0f}, {0.0f, 0.0f}, {-0.0f, 0.0f}, {0.0f, -0.0f}, {-0.0f, -0.0f}};
    const std::vector<float> wanted = {0.0f,  0.0f,  0.25f, 0.25f, 0.5f, 0.5f,
                                       0.75f, 0.75f, 0.0f,  0.0f,  0.0f, 0.0f};
    EXPECT_EQ(runKernel<float>(kAngleInTurnsSpirv, points), wanted);
}

} // namespace
} // namespace calotype::test
