#include "film/fixed_point.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace calotype {
namespace {

/// value * 2^64, rounded to nearest with halves away from zero, in integers alone.
FixedPoint exactly(float value) {
    const auto bits = std::bit_cast<uint32_t>(value);
    const int exponentBits = static_cast<int>(bits >> 23 & 0xff);
    const FixedPoint mantissa = (bits & 0x7fffff) | (exponentBits > 0 ? 0x800000 : 0);
    const int shift = std::max(exponentBits, 1) - 150 + 64;
    FixedPoint magnitude = 0;
    if (shift >= 0)
        magnitude = mantissa << shift;
    else if (shift >= -25)
        magnitude = (mantissa + (FixedPoint{1} << (-shift - 1))) >> -shift;
    return value < 0.0f ? -magnitude : magnitude;
}

TEST(FixedPointTest, MatchesIntegerArithmeticForFloatsOfEverySize) {
    std::mt19937 random(1);
    std::uniform_int_distribution<uint32_t> mantissas(0, 0x7fffff);
    for (uint32_t exponentBits = 0; exponentBits < 127 + 40; ++exponentBits)
        for (int i = 0; i < 2000; ++i) {
            const uint32_t mantissa =
                i == 0 ? 0 : (i == 1 ? 0x7fffff : (i == 2 ? 0x400000 : mantissas(random)));
            const float value = std::bit_cast<float>(exponentBits << 23 | mantissa);
            ASSERT_TRUE(toFixedPoint(value) == exactly(value)) << value;
            ASSERT_TRUE(toFixedPoint(-value) == exactly(-value)) << -value;
        }
    EXPECT_TRUE(toFixedPoint(kFixedPointTermLimit) == FixedPoint{1} << 104);
    EXPECT_TRUE(toFixedPoint(-kFixedPointTermLimit) == -(FixedPoint{1} << 104));
}

TEST(FixedPointTest, ComesBack) {
    for (float value : {0.0f, 1.0f, -0.1f, 0x1.fffffep-18f, -0x1.abcdeep39f})
        EXPECT_EQ(fromFixedPoint(toFixedPoint(value)), value);
}

} // namespace
} // namespace calotype
