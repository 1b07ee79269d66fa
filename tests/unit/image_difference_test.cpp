// Each figure against a value worked out by hand, and what is left out of them.
#include "image/difference.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/image_means.h"

namespace calotype {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Of doubles that are sums of a few floats.
constexpr double kRounding = 1e-14;

Image make(uint32_t width, uint32_t height, std::vector<glm::vec3> pixels) {
    Image image(width, height);
    image.pixels = std::move(pixels);
    return image;
}

const Image kA = make(2, 2, {{1, 2, 3}, {0, 0, 0}, {0.5f, 0, 8}, {1, 1, 1}});
const Image kB = make(2, 2, {{1, 1, 3}, {0, 0, 0}, {0, 0.25f, 10}, {1, 1, 1}});

TEST(DifferenceTest, AgreesWithTheFiguresByHand) {
    const ImageDifference difference = measureDifference(kA, kB);
    EXPECT_EQ(difference.meanError, glm::dvec3(0.125, 0.1875, -0.5));
    const double squares = 1.0 + 0.25 + 0.0625 + 4.0;
    EXPECT_NEAR(difference.rmse, std::sqrt(squares / 12.0), kRounding);
    const double relative = 1.0 / 1.01 + 0.25 / 0.01 + 0.0625 / 0.0725 + 4.0 / 100.01;
    EXPECT_NEAR(difference.relativeMse, relative / 12.0, kRounding);
    EXPECT_EQ(difference.peak, 10.0);
    EXPECT_NEAR(difference.psnr(), 10.0 * std::log10(100.0 / (squares / 12.0)), 1e-12);
    EXPECT_EQ(difference.largest.magnitude, 2.0);
    EXPECT_EQ(difference.largest.x, 0u);
    EXPECT_EQ(difference.largest.y, 1u);
    EXPECT_EQ(difference.largest.channel, 2);
    EXPECT_EQ(difference.infiniteInA, 0u);
    EXPECT_EQ(difference.infiniteInB, 0u);
    EXPECT_EQ(difference.leftOut, 0u);
}

TEST(DifferenceTest, OfEqualPicturesIsNothing) {
    const ImageDifference difference = measureDifference(kA, kA);
    EXPECT_EQ(difference.meanError, glm::dvec3(0.0));
    EXPECT_EQ(difference.rmse, 0.0);
    EXPECT_EQ(difference.relativeMse, 0.0);
    EXPECT_EQ(difference.psnr(), std::numeric_limits<double>::infinity());
    EXPECT_EQ(difference.largest.magnitude, 0.0);
}

TEST(DifferenceTest, WithoutAPeakHasNoDecibels) {
    const ImageDifference difference =
        measureDifference(make(1, 1, {{1, 1, 1}}), make(1, 1, {{0, -1, 0}}));
    EXPECT_EQ(difference.peak, 0.0);
    EXPECT_EQ(difference.psnr(), -std::numeric_limits<double>::infinity());
}

TEST(DifferenceTest, TakesTheFirstOfEqualExtremes) {
    const ImageDifference difference = measureDifference(
        make(3, 1, {{0, 0, 0}, {0, -1, 1}, {1, 0, 0}}), make(3, 1, {{0, 0, 0}, {0, 0, 0}, {}}));
    EXPECT_EQ(difference.largest.x, 1u);
    EXPECT_EQ(difference.largest.channel, 1);
}

TEST(DifferenceTest, OfExtremeFloatsStaysFinite) {
    constexpr float kMax = std::numeric_limits<float>::max();
    const ImageDifference difference =
        measureDifference(make(1, 1, {glm::vec3(kMax)}), make(1, 1, {glm::vec3(-kMax)}));
    EXPECT_NEAR(difference.rmse / kMax, 2.0, kRounding);
    EXPECT_NEAR(difference.relativeMse, 4.0, kRounding);
    EXPECT_EQ(difference.largest.magnitude, 2.0 * kMax);
}

TEST(DifferenceTest, LeavesOutAndCountsInfinitePixels) {
    // Infinite in A, in B, in both; the last pixel alone counts.
    const Image a = make(4, 1, {{kInfinity, 0, 0}, {7, 7, 7}, {0, -kInfinity, 0}, {1, 1, 1.5f}});
    const Image b = make(4, 1, {{9, 9, 9}, {7, 7, kInfinity}, {0, -kInfinity, 0}, {1, 1, 1}});
    const ImageDifference difference = measureDifference(a, b);
    EXPECT_EQ(difference.infiniteInA, 2u);
    EXPECT_EQ(difference.infiniteInB, 2u);
    EXPECT_EQ(difference.leftOut, 3u);
    EXPECT_EQ(difference.infiniteInOne(), 2u);
    EXPECT_EQ(difference.meanError, glm::dvec3(0, 0, 0.5));
    EXPECT_NEAR(difference.rmse, std::sqrt(0.25 / 3.0), kRounding);
    EXPECT_NEAR(difference.relativeMse, 0.25 / 1.01 / 3.0, kRounding);
    EXPECT_EQ(difference.peak, 1.0);
    EXPECT_EQ(difference.largest.x, 3u);
}

void expectRefused(const Image& a, const Image& b, const std::string& message) {
    try {
        requireComparable(a, "a.exr", b, "b.exr");
        ADD_FAILURE() << "nothing was thrown; expected: " << message;
    } catch (const SceneError& error) {
        EXPECT_EQ(std::string(error.what()).rfind(message, 0), 0u) << error.what();
    }
}

TEST(RequireComparableTest, RefusesOtherSizes) {
    expectRefused(Image(2, 3), Image(3, 2),
                  "a.exr: the picture has 2 x 3 pixels and 'b.exr' has 3 x 2");
    expectRefused(Image(2, 3), Image(2, 4),
                  "a.exr: the picture has 2 x 3 pixels and 'b.exr' has 2 x 4");
}

TEST(RequireComparableTest, RefusesNanAndSaysWhere) {
    Image broken = kA;
    broken.at(1, 0).z = NAN;
    broken.at(0, 1) = {NAN, NAN, 0};
    expectRefused(broken, kB, "a.exr: 2 of 4 pixels are NaN, the first at (1, 0)");
    expectRefused(kA, broken, "b.exr: 2 of 4 pixels are NaN, the first at (1, 0)");
}

TEST(RequireComparableTest, RefusesPicturesWithNothingToCompare) {
    const Image a = make(2, 1, {{kInfinity, 0, 0}, {0, 0, 0}});
    const Image b = make(2, 1, {{0, 0, 0}, {0, 0, -kInfinity}});
    expectRefused(a, b, "a.exr: no pixel is finite both here and in 'b.exr'");
    EXPECT_NO_THROW(requireComparable(a, "a", a, "a"));
    EXPECT_NO_THROW(requireComparable(kA, "a", kB, "b"));
}

} // namespace
} // namespace calotype
