#include <cmath>

#include <gtest/gtest.h>

#include "math/bounds.h"
#include "math/outward_rounding.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(BoundsTest, AreEmptyUntilExtended) {
    Bounds3d bounds;
    EXPECT_TRUE(bounds.isEmpty());
    bounds.extend(glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_FALSE(bounds.isEmpty());
    EXPECT_EQ(bounds.extent(), glm::dvec3(0.0));
    bounds.extend(Bounds3d{{0.0, 5.0, 3.0}, {1.0, 6.0, 4.0}});
    EXPECT_EQ(bounds.lower, glm::dvec3(0.0, 2.0, 3.0));
    EXPECT_EQ(bounds.upper, glm::dvec3(1.0, 6.0, 4.0));
    bounds.extend(Bounds3d{});
    EXPECT_EQ(bounds.upper, glm::dvec3(1.0, 6.0, 4.0));
}

TEST(BoundsTest, ContainWhatLiesWithinOnAllAxes) {
    const Bounds3d box{glm::dvec3(0.0), glm::dvec3(1.0)};
    EXPECT_TRUE(box.contains(box));
    EXPECT_TRUE(box.contains(Bounds3d{}));
    for (int axis = 0; axis < 3; ++axis) {
        Bounds3d beyond = box;
        beyond.upper[axis] = 1.5;
        EXPECT_FALSE(box.contains(beyond));
        beyond = box;
        beyond.lower[axis] = -0.5;
        EXPECT_FALSE(box.contains(beyond));
    }
}

TEST(BoundsTest, HalfAreaIsOfThreeSides) {
    EXPECT_DOUBLE_EQ(halfArea(Bounds3f{{0, 0, 0}, {1, 2, 3}}), 2.0 + 6.0 + 3.0);
    EXPECT_DOUBLE_EQ(halfArea(Bounds3f{{0, 1, 0}, {2, 1, 3}}), 6.0);
}

TEST(OutwardRoundingTest, FindsTheNearestFloatsOnBothSides) {
    RandomNumbers random(51);
    for (int i = 0; i < 100'000; ++i) {
        const double x = random.sign() * random.powerOfTen(-44.0, 38.0);
        const float down = roundDown(x);
        const float up = roundUp(x);
        ASSERT_LE(double(down), x);
        ASSERT_GE(double(up), x);
        ASSERT_LT(x, double(std::nextafter(down, kInfinity)));
        ASSERT_GT(x, double(std::nextafter(up, -kInfinity)));
    }
}

TEST(OutwardRoundingTest, KeepsFloatsAndSurvivesTheEnds) {
    for (const float x : {0.0f, -0.0f, 1.0f, -3.5f, 0x1p-149f, std::numeric_limits<float>::max()}) {
        EXPECT_EQ(roundDown(x), x);
        EXPECT_EQ(roundUp(x), x);
    }
    EXPECT_EQ(roundDown(1e-60), 0.0f);
    EXPECT_EQ(roundUp(1e-60), 0x1p-149f);
    EXPECT_EQ(roundUp(1e60), kInfinity);
    EXPECT_EQ(roundDown(1e60), std::numeric_limits<float>::max());
    EXPECT_EQ(roundDown(-1e60), -kInfinity);
}

} // namespace
} // namespace calotype::test
