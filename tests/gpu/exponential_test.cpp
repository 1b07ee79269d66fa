// log(1 + x) and exp(x) - 1 in relative error. Vulkan promises 3 ULP of a logarithm above 2,
// 3 + 2 x ULP of an exponential and 2.5 ULP of a quotient; the series state 2e-7.
#include <cmath>

#include <glm/vec2.hpp>

#include "kernels/exponential.spv.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

/// Of the series, and of its quotient, products and sums.
constexpr double kSeriesError = 2e-7 + 4.0 * kRoundoffOfFloat;

/// Spread evenly over the powers of ten, with both sides of the limits of the series.
std::vector<float> numbersUpTo(double powerOfTen) {
    RandomNumbers random(131);
    std::vector<float> numbers = {0.49999997f, 0.5f, 0.99999994f, 1.0f};
    while (numbers.size() < 200'000)
        numbers.push_back(static_cast<float>(random.powerOfTen(-12.0, powerOfTen)));
    return numbers;
}

class ExponentialTest : public GpuTest {};

TEST_F(ExponentialTest, LogOnePlusKeepsItsDigits) {
    const auto numbers = numbersUpTo(12.0);
    const auto results = runKernel<glm::vec2>(kExponentialSpirv, numbers);
    double worst = 0.0;
    for (size_t i = 0; i < numbers.size(); ++i) {
        const double wanted = std::log1p(static_cast<double>(numbers[i]));
        worst = std::max(worst, std::abs(results[i].x / wanted - 1.0));
    }
    RecordProperty("worstTimes1e9", std::to_string(worst * 1e9));
    EXPECT_LT(worst, kSeriesError);
}

TEST_F(ExponentialTest, ExpMinusOneKeepsItsDigits) {
    const auto numbers = numbersUpTo(std::log10(80.0));
    const auto results = runKernel<glm::vec2>(kExponentialSpirv, numbers);
    for (size_t i = 0; i < numbers.size(); ++i) {
        const double x = numbers[i];
        const double wanted = std::expm1(x);
        // The difference magnifies the exponential's error, 2.6 times at most.
        const double promised = (4.0 + 2.0 * x) * kRoundoffOfFloat * std::exp(x) / wanted;
        ASSERT_NEAR(results[i].y / wanted, 1.0, x < 0.5 ? kSeriesError : promised) << x;
    }
}

TEST_F(ExponentialTest, BeginsAtZeroAndEndsAtInfinity) {
    const auto results = runKernel<glm::vec2>(kExponentialSpirv, std::vector<float>{0.0f, 200.0f});
    EXPECT_EQ(results[0], glm::vec2(0.0f));
    EXPECT_TRUE(std::isinf(results[1].y));
}

} // namespace
} // namespace calotype::test
