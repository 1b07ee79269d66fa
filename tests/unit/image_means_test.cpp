#include "support/image_means.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace calotype::test {
namespace {

Image make(uint32_t width, uint32_t height, std::vector<glm::vec3> pixels) {
    Image image(width, height);
    image.pixels = std::move(pixels);
    return image;
}

TEST(ImageMeanTest, AveragesEachChannelInDouble) {
    EXPECT_EQ(imageMean(make(2, 1, {{1, 2, 3}, {3, 6, -3}})), glm::dvec3(2, 4, 0));
    EXPECT_EQ(imageMean(make(2, 1, {{16777216, 0, 0}, {1, 0, 0}})).r, 8388608.5);
    EXPECT_THROW(imageMean(Image()), Error);
}

TEST(BoxDownsampleTest, AveragesSquares) {
    const Image image = make(
        4, 2,
        {{1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 1, 0}, {3, 0, 4}, {6, 0, 0}, {0, 1, 0}, {0, 5, 0}});
    const Image small = boxDownsample(image, 2);
    ASSERT_EQ(small.width, 2u);
    ASSERT_EQ(small.height, 1u);
    EXPECT_EQ(small.at(0, 0), glm::vec3(3, 0, 1));
    EXPECT_EQ(small.at(1, 0), glm::vec3(0, 2, 0));
}

TEST(BoxDownsampleTest, RefusesAFactorThatDoesNotDivide) {
    EXPECT_THROW(boxDownsample(Image(4, 2), 4), Error);
    EXPECT_THROW(boxDownsample(Image(4, 2), 0), Error);
}

} // namespace
} // namespace calotype::test
