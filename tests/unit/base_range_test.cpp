// Ranges: which numbers belong to them, and how messages say so.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/range.h"

namespace calotype::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(RangeTest, EndsBelongToItUnlessTheyAreOpen) {
    EXPECT_TRUE(closedRange(0.0, 1.0).contains(0.0));
    EXPECT_TRUE(closedRange(0.0, 1.0).contains(1.0));
    EXPECT_FALSE(closedRange(0.0, 1.0).contains(std::nextafter(1.0, 2.0)));
    EXPECT_FALSE(closedRange(0.0, 1.0).contains(-std::numeric_limits<double>::denorm_min()));
    EXPECT_FALSE(openRange(0.0, 180.0).contains(0.0));
    EXPECT_FALSE(openRange(0.0, 180.0).contains(180.0));
    EXPECT_TRUE(openRange(0.0, 180.0).contains(std::nextafter(180.0, 0.0)));
    EXPECT_TRUE(atLeast(0.0).contains(0.0));
    EXPECT_FALSE(greaterThan(0.0).contains(0.0));
    EXPECT_TRUE(greaterThan(0.0).contains(std::numeric_limits<double>::denorm_min()));
}

TEST(RangeTest, HoldsFiniteNumbersOnly) {
    for (const Range& range : {Range{}, atLeast(0.0), greaterThan(0.0), closedRange(0.0, 1.0)}) {
        EXPECT_FALSE(range.contains(kInfinity));
        EXPECT_FALSE(range.contains(-kInfinity));
        EXPECT_FALSE(range.contains(NAN));
    }
    EXPECT_TRUE(Range{}.contains(-1e308));
}

TEST(RangeTest, IsSaidInWords) {
    EXPECT_EQ(toText(Range{}), "a finite number");
    EXPECT_EQ(toText(closedRange(0.0, 1.0)), "in [0, 1]");
    EXPECT_EQ(toText(openRange(0.0, 180.0)), "between 0 and 180, both excluded");
    EXPECT_EQ(toText(atLeast(0.0)), "0 or greater");
    EXPECT_EQ(toText(greaterThan(0.0)), "greater than 0");
    EXPECT_EQ(toText({0.0, 5.0, true, false}), "greater than 0 and at most 5");
}

} // namespace
} // namespace calotype::test
