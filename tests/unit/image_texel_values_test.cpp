// What all texels of an image have in common: their extremes and their mean.

#include <gtest/gtest.h>

#include "image/texel_values.h"

namespace calotype::test {
namespace {

TexelImage bytesOf(const std::vector<uint8_t>& bytes, bool isEncoded) {
    return {static_cast<uint32_t>(bytes.size() / 4), 1, bytes, {}, isEncoded, false};
}

TexelImage floatsOf(const std::vector<float>& floats, bool isEncoded) {
    return {static_cast<uint32_t>(floats.size() / 4), 1, {}, floats, isEncoded, false};
}

TEST(TexelRangeTest, IsOfEachColour) {
    const TexelRange bytes =
        texelRange(bytesOf({51, 102, 0, 1, 153, 0, 255, 2, 0, 204, 102, 3}, true));
    EXPECT_EQ(bytes.least, glm::dvec3(0.0));
    EXPECT_DOUBLE_EQ(bytes.greatest.x, 0.6);
    EXPECT_DOUBLE_EQ(bytes.greatest.y, 0.8);
    EXPECT_EQ(bytes.greatest.z, 1.0);
    const TexelRange floats =
        texelRange(floatsOf({2.5f, 0.5f, 8.0f, 9.0f, 3.0f, 0.25f, 4.0f, 9.0f}, true));
    EXPECT_EQ(floats.least, glm::dvec3(2.5, 0.25, 4.0));
    EXPECT_EQ(floats.greatest, glm::dvec3(3.0, 0.5, 8.0));
}

TEST(MeanColorTest, DecodesBeforeItAverages) {
    // IEC 61966-2-1: 128 / 255 is 0.2158605 in linear light.
    const TexelImage bytes = bytesOf({255, 128, 0, 7, 0, 128, 0, 9}, true);
    const glm::dvec3 linear = meanColor(bytes, true);
    EXPECT_DOUBLE_EQ(linear.x, 0.5);
    EXPECT_NEAR(linear.y, 0.2158605, 1e-7);
    EXPECT_EQ(linear.z, 0.0);
    EXPECT_DOUBLE_EQ(meanColor(bytes, false).y, 128.0 / 255.0);
    EXPECT_DOUBLE_EQ(meanColor(bytesOf({255, 128, 0, 7}, false), true).y, 128.0 / 255.0);

    const std::vector<float> samples = {4.0f, 0.5f, 0.0f, 1.0f, 2.0f, 0.5f, 0.0f, 1.0f};
    EXPECT_EQ(meanColor(floatsOf(samples, false), true), glm::dvec3(3.0, 0.5, 0.0));
    EXPECT_NEAR(meanColor(floatsOf(samples, true), true).y, 0.2140411, 1e-7);
}

// sum(a c) / sum(a) by hand.
TEST(MeanColorTest, WeighsByAlphaIfAsked) {
    const TexelImage bytes = bytesOf({255, 51, 0, 255, 0, 102, 0, 0, 0, 204, 0, 85}, false);
    const glm::dvec3 weighted = meanColor(bytes, false, AlphaWeights::Yes);
    EXPECT_DOUBLE_EQ(weighted.x, 0.75);
    EXPECT_DOUBLE_EQ(weighted.y, (3.0 * 0.2 + 0.8) / 4.0);
    EXPECT_DOUBLE_EQ(meanColor(bytes, false).x, 1.0 / 3.0);
    const TexelImage floats = floatsOf({8.0f, 0.0f, 2.0f, 0.25f, 0.0f, 4.0f, 2.0f, 0.75f}, false);
    EXPECT_EQ(meanColor(floats, true, AlphaWeights::Yes), glm::dvec3(2.0, 3.0, 2.0));
    // Nothing can be seen of it: no weights.
    const TexelImage empty = bytesOf({255, 0, 0, 0, 0, 0, 0, 0}, false);
    EXPECT_EQ(meanColor(empty, false, AlphaWeights::Yes), glm::dvec3(0.5, 0.0, 0.0));
}

} // namespace
} // namespace calotype::test
