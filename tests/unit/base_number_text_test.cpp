#include "base/number_text.h"

#include <gtest/gtest.h>

namespace calotype {
namespace {

TEST(NumberTextTest, PercentHasThreeDigits) {
    EXPECT_EQ(percentText(0.0), "0.00 %");
    EXPECT_EQ(percentText(0.0123), "1.23 %");
    EXPECT_EQ(percentText(0.1234), "12.3 %");
    EXPECT_EQ(percentText(1.234), "123 %");
}

TEST(NumberTextTest, SmallPercentIsNotShownAsZero) {
    EXPECT_EQ(percentText(1e-5), "0.001 %");
    EXPECT_EQ(percentText(3.4e-6), "0.0003 %");
}

} // namespace
} // namespace calotype
