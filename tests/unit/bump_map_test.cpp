// Heights and steeper normals to normal maps.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/bump_map.h"

namespace calotype {
namespace {

template <typename Value>
TexelImage imageOf(uint32_t width, uint32_t height, Value value) {
    TexelImage image;
    image.width = width;
    image.height = height;
    for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
            for (int k = 0; k < 3; ++k)
                image.floats.push_back(static_cast<float>(value(x, y)));
            image.floats.push_back(1.0f);
        }
    }
    return image;
}

TexelImage imageOfColor(float red, float green, float blue) {
    TexelImage image;
    image.width = 1;
    image.height = 1;
    image.floats = {red, green, blue, 1.0f};
    return image;
}

/// The normal that texel (x, y) means.
std::array<double, 3> normalAt(const TexelImage& map, uint32_t x, uint32_t y) {
    std::array<double, 3> n{};
    for (size_t k = 0; k < 3; ++k)
        n[k] = 2.0 * map.floats[4 * (size_t{y} * map.width + x) + k] - 1.0;
    return n;
}

TEST(BumpMapTest, FlatHeightsAreExactlyFlat) {
    const TexelImage map =
        normalMapFromHeights(imageOf(3, 2, [](auto, auto) { return 0.7; }), TexelChannel::Red, 5.0);
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(map.floats[4 * i], 0.5f);
        EXPECT_EQ(map.floats[4 * i + 1], 0.5f);
        EXPECT_EQ(map.floats[4 * i + 2], 1.0f);
        EXPECT_EQ(map.floats[4 * i + 3], 1.0f);
    }
    EXPECT_FALSE(map.isEncoded);
}

TEST(BumpMapTest, NormalsAreThoseOfTheHeightField) {
    // A wave each way over one period, so that wrapping around is seamless.
    constexpr uint32_t kSide = 256;
    constexpr double kSteepness = 20.0;
    const double step = 2.0 * std::numbers::pi / kSide;
    const auto wave = [&](uint32_t x, uint32_t y) {
        return 0.5 + 0.2 * std::sin(x * step) + 0.1 * std::cos(2.0 * y * step);
    };
    const TexelImage map =
        normalMapFromHeights(imageOf(kSide, kSide, wave), TexelChannel::Red, kSteepness);
    for (uint32_t y = 0; y < kSide; y += 5) {
        for (uint32_t x = 0; x < kSide; x += 5) {
            const double slopeU = kSteepness * 0.2 * step * std::cos(x * step);
            const double slopeDown = kSteepness * -0.2 * step * std::sin(2.0 * y * step);
            const double length = std::sqrt(slopeU * slopeU + slopeDown * slopeDown + 1.0);
            const auto n = normalAt(map, x, y);
            // Central differences err by step^2 / 6 of the slope; heights by half a float.
            EXPECT_NEAR(n[0], -slopeU / length, 1e-4);
            EXPECT_NEAR(n[1], slopeDown / length, 1e-4); // v runs up, rows down
            EXPECT_NEAR(n[2], 1.0 / length, 1e-4);
        }
    }
}

TEST(BumpMapTest, WrapsAround) {
    const TexelImage ramp = imageOf(4, 1, [](uint32_t x, auto) { return x * 0.25; });
    const TexelImage map = normalMapFromHeights(ramp, TexelChannel::Red, 1.0);
    const auto first = normalAt(map, 0, 0);
    EXPECT_NEAR(first[0] / first[2], -0.5 * (0.25 - 0.75), 1e-6);
    const auto last = normalAt(map, 3, 0);
    EXPECT_NEAR(last[0] / last[2], -0.5 * (0.0 - 0.5), 1e-6);
}

TEST(BumpMapTest, SteepensNormals) {
    // (3, 0, 4) / 5, twice as steep: (6, 0, 4).
    const auto n = normalAt(steepenedNormalMap(imageOfColor(0.8f, 0.5f, 0.9f), 2.0), 0, 0);
    EXPECT_NEAR(n[0] / n[2], 1.5, 1e-6);
    EXPECT_NEAR(n[1], 0.0, 1e-6);
    EXPECT_NEAR(n[0] * n[0] + n[2] * n[2], 1.0, 1e-6);
    const auto none = normalAt(steepenedNormalMap(imageOfColor(0.5f, 0.5f, 0.5f), 2.0), 0, 0);
    EXPECT_EQ(none[2], 1.0);
}

TEST(BumpMapTest, NormalMapsHaveTheMeanOfNormals) {
    EXPECT_TRUE(looksLikeNormals(imageOfColor(0.5f, 0.5f, 1.0f)));
    EXPECT_TRUE(looksLikeNormals(imageOfColor(0.54f, 0.46f, 0.78f)));
    EXPECT_FALSE(looksLikeNormals(imageOfColor(0.56f, 0.5f, 1.0f))); // x is 0.12
    EXPECT_FALSE(looksLikeNormals(imageOfColor(0.5f, 0.44f, 1.0f)));
    EXPECT_FALSE(looksLikeNormals(imageOfColor(0.5f, 0.5f, 0.77f))); // z is 0.54
    EXPECT_FALSE(looksLikeNormals(imageOfColor(0.8f, 0.6f, 0.4f)));
    TexelImage bytes;
    bytes.width = bytes.height = 1;
    bytes.bytes = {128, 128, 250, 255};
    bytes.isEncoded = true; // as all images of bytes; normals are not decoded
    EXPECT_TRUE(looksLikeNormals(bytes));
}

TEST(BumpMapTest, SeparatesHeightsFromNormals) {
    EXPECT_TRUE(isGrey(imageOfColor(0.3f, 0.3f, 0.3f)));
    EXPECT_TRUE(isGrey(imageOfColor(0.30f, 0.33f, 0.31f))); // a JPEG's noise
    EXPECT_FALSE(isGrey(imageOfColor(0.5f, 0.5f, 1.0f)));
    EXPECT_FALSE(isGrey(imageOfColor(0.7f, 0.6f, 0.85f)));
}

} // namespace
} // namespace calotype
