// What rounding takes from sums and products, to the last bit.
#include <cmath>

#include <glm/vec4.hpp>

#include "kernels/error_free.spv.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

class ErrorFreeTest : public GpuTest {
protected:
    /// Of both signs, over eight decades.
    static std::vector<glm::vec4> someNumbers() {
        RandomNumbers random(301);
        const auto number = [&] {
            return static_cast<float>(random.sign() * random.powerOfTen(-4.0, 4.0));
        };
        std::vector<glm::vec4> numbers(20'000);
        for (glm::vec4& n : numbers)
            n = {number(), number(), number(), number()};
        return numbers;
    }
};

TEST_F(ErrorFreeTest, SumsAndProductsLeaveWhatTheyRoundOff) {
    const std::vector<glm::vec4> numbers = someNumbers();
    const auto errors = runKernel<glm::vec4>(kErrorFreeSpirv, numbers);
    for (size_t i = 0; i < numbers.size(); ++i) {
        const glm::dvec4 n(numbers[i]);
        // Doubles hold sums over eight decades and products of floats exactly.
        EXPECT_EQ(errors[i].x, n.x + n.y - double{static_cast<float>(n.x + n.y)});
        EXPECT_EQ(errors[i].y, n.x * n.y - double{static_cast<float>(n.x * n.y)});
    }
}

TEST_F(ErrorFreeTest, DifferencesOfProductsDoNotCancel) {
    std::vector<glm::vec4> numbers = someNumbers();
    for (size_t i = 0; i < numbers.size(); i += 2) // and some that nearly do
        numbers[i].w = numbers[i].x * numbers[i].y / numbers[i].z;
    const auto errors = runKernel<glm::vec4>(kErrorFreeSpirv, numbers);
    for (size_t i = 0; i < numbers.size(); ++i) {
        const glm::dvec4 n(numbers[i]);
        const double expected = n.x * n.y - n.z * n.w;
        EXPECT_NEAR(errors[i].z, expected,
                    0x1p-23 * std::abs(expected) + 0x1p-46 * std::abs(n.x * n.y));
    }
}

} // namespace
} // namespace calotype::test
