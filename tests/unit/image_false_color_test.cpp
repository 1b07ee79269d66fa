// The false colours, by an Oklab of their own, and what they stand for in a difference picture.
#include "image/false_color.h"

#include <cmath>
#include <limits>
#include <ostream>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "image/difference_picture.h"

namespace calotype {
namespace {

/// Oklab of a colour of sRGB, by the matrices from linear Rec. 709 (Ottosson 2020).
glm::dvec3 oklab(const glm::u8vec3& color) {
    const auto linear = [](double encoded) {
        const double x = encoded / 255.0;
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    const double r = linear(color.r);
    const double g = linear(color.g);
    const double b = linear(color.b);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

// In 16 steps each is 0.054; 8 bits place a colour to within about 0.003, most in the dark.
TEST(FalseColorTest, StepsLookEquallyLargeAndGrowLighter) {
    constexpr int kSteps = 16;
    constexpr double kPlacement = 0.003;
    const double lightnessStep = (0.90 - 0.25) / kSteps;
    const double turn = 200.0 / kSteps * M_PI / 180.0;
    const double step = std::hypot(lightnessStep, 2.0 * 0.165 * std::sin(turn / 2.0));
    for (int i = 0; i < kSteps; ++i) {
        const glm::dvec3 first = oklab(falseColor(static_cast<double>(i) / kSteps));
        const glm::dvec3 second = oklab(falseColor(static_cast<double>(i + 1) / kSteps));
        EXPECT_NEAR(glm::distance(first, second), step, 2.0 * kPlacement) << i;
        EXPECT_NEAR(second.x - first.x, lightnessStep, 2.0 * kPlacement) << i;
    }
}

TEST(FalseColorTest, IsClamped) {
    EXPECT_EQ(falseColor(-1.0), falseColor(0.0));
    EXPECT_EQ(falseColor(2.0), falseColor(1.0));
}

// docs/pictures.md lists these colours.
TEST(DifferencePictureTest, ShowsKnownDifferences) {
    const struct {
        float difference; ///< from black, in every channel: ten times as much relatively
        glm::u8vec3 color;
    } cases[] = {{0.0f, {0, 0, 0}},       {0.99e-5f, {0, 0, 0}},   {1.0001e-5f, {2, 5, 110}},
                 {1e-4f, {107, 34, 135}}, {1e-3f, {196, 68, 108}}, {1e-2f, {247, 137, 46}},
                 {0.1f, {239, 227, 77}},  {1e30f, {239, 227, 77}}, {-1e-3f, {196, 68, 108}}};
    for (const auto& [difference, color] : cases) {
        Image a(1, 1);
        a.pixels[0] = glm::vec3(difference);
        EXPECT_EQ(differencePicture(a, Image(1, 1)).pixels[0], color) << difference;
    }
}

TEST(DifferencePictureTest, WeighsByTheReferenceAndAveragesTheChannels) {
    Image a(2, 1);
    Image b(2, 1);
    // 0.01 of 1 in every channel, and once in one channel: the root of a third.
    b.pixels = {{1, 1, 1}, {1, 1, 1}};
    a.pixels = {{1.01f, 0.99f, 1.01f}, {1, 1.01f, 1}};
    const Rgb8Image picture = differencePicture(a, b);
    const auto position = [](double relative) { return std::log10(relative / 1e-4) / 4.0; };
    EXPECT_EQ(picture.at(0, 0), falseColor(position(0.01 / std::sqrt(1.01))));
    EXPECT_EQ(picture.at(1, 0), falseColor(position(0.01 / std::sqrt(1.01 * 3.0))));
    EXPECT_NE(picture.at(0, 0), picture.at(1, 0));
}

TEST(DifferencePictureTest, MarksInfinitePixels) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Image a(3, 1);
    Image b(3, 1);
    a.pixels = {{0, kInfinity, 0}, {0, 0, 0}, {0, 0, 0}};
    b.pixels = {{0, 0, 0}, {0, 0, 0}, {-kInfinity, 0, 0}};
    const Rgb8Image picture = differencePicture(a, b);
    EXPECT_EQ(picture.at(0, 0), glm::u8vec3(0, 255, 255));
    EXPECT_EQ(picture.at(1, 0), glm::u8vec3(0, 0, 0));
    EXPECT_EQ(picture.at(2, 0), glm::u8vec3(0, 255, 255));
}

} // namespace
} // namespace calotype
