#include "denoise/statistical_denoiser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "math/square.h"
#include "shared/denoise_structs.h"
#include "support/noisy_image.h"

namespace calotype::test {
namespace {

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 40;
constexpr auto kRadius = static_cast<int>(shared::kDenoiserRadius);

Image denoised(const NoisyImage& noisy) {
    return StatisticalDenoiser(noFeatures(noisy.color), 2).run(noisy);
}

/// The right half is brighter by `step`.
Image edge(const glm::vec3& step) {
    Image image = constantImage(kWidth, kHeight, glm::vec3(1.0f));
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = kWidth / 2; x < kWidth; ++x)
            image.at(x, y) += step;
    return image;
}

glm::dvec3 meanOf(const Image& image) {
    glm::dvec3 sum(0.0);
    for (const glm::vec3& pixel : image.pixels)
        sum += glm::dvec3(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

/// Whether a pixel's square is whole.
bool isInside(uint32_t x, uint32_t y) {
    return int(x) >= kRadius && int(x) + kRadius < int(kWidth) && int(y) >= kRadius &&
           int(y) + kRadius < int(kHeight);
}

double weightAt(int x, int y) { return std::exp(-0.5 * (x * x + y * y) / square(4.0)); }

// So much noise that all pixels are alike.
TEST(StatisticalDenoiserTest, WeighsPixelsByTheirDistance) {
    Image dot(kWidth, kHeight);
    dot.at(20, 19) = glm::vec3(1.0f);
    const Image image = denoised(withError(dot, 10.0f));
    double sum = 0.0;
    for (int y = -kRadius; y <= kRadius; ++y)
        for (int x = -kRadius; x <= kRadius; ++x)
            sum += weightAt(x, y);
    for (int y = 0; y < int(kHeight); ++y)
        for (int x = 0; x < int(kWidth); ++x) {
            const bool isNear = std::abs(x - 20) <= kRadius && std::abs(y - 19) <= kRadius;
            EXPECT_NEAR(image.at(x, y).g, isNear ? weightAt(x - 20, y - 19) / sum : 0.0, 1e-8)
                << x << " " << y;
        }
}

// A mean with these weights leaves 1/177 of the variance. A few pairs are not mixed though they are
// alike; most of those are of pixels far from the truth, which keep some of their own noise. So
// half as much again or twice as much is left; and it would be four times as much if each pixel's
// own variance, from eight numbers, were used.
TEST(StatisticalDenoiserTest, AConstantPictureBecomesItsMean) {
    constexpr uint32_t kSide = 112;
    NoisyImage noisy = noisyImage(kSide, kSide, 8, 1, [](auto, auto, auto, std::mt19937& random) {
        return std::normal_distribution(2.0, 0.5 * std::sqrt(8.0))(random);
    });
    for (Image* image : {&noisy.color, &noisy.standardError}) // grey, as most noise is
        for (glm::vec3& pixel : image->pixels)
            pixel = glm::vec3(pixel.g);
    const Image image = denoised(noisy);
    double squares = 0.0;
    for (uint32_t y = kRadius; y < kSide - kRadius; ++y)
        for (uint32_t x = kRadius; x < kSide - kRadius; ++x)
            squares += square(image.at(x, y).g - 2.0) / square(kSide - 2 * kRadius);
    const double share = squares / square(0.5);
    EXPECT_GT(share, 0.7 / 177.0); // about 46 squares are independent
    EXPECT_LT(share, 1.0 / 60.0);
}

// The bound is 2.977 standard errors of the difference, 4.21 of a pixel.
TEST(StatisticalDenoiserTest, AnEdgeThatTheSamplesShowKeepsEveryBit) {
    for (const glm::vec3 step : {glm::vec3(0.6f), glm::vec3(0.0f, 0.0f, 0.6f),
                                 glm::vec3(0.43f, 0.0f, 0.0f), glm::vec3(0.0f, 0.43f, 0.0f)}) {
        const NoisyImage noisy = withError(edge(step), 0.1f);
        EXPECT_EQ(denoised(noisy).pixels, noisy.color.pixels) << step.r << " " << step.g;
    }
    // The mean of a patch of nine pixels has a third of the standard error: the bound is 1.4 of a
    // pixel's.
    const Image blurred = denoised(withError(edge(glm::vec3(0.1f)), 0.1f));
    EXPECT_GT(blurred.at(kWidth / 2 - 1, 20).g, 1.02f);
    const Image kept = denoised(withError(edge(glm::vec3(0.25f)), 0.1f));
    EXPECT_EQ(kept.at(kWidth / 2 - 4, 20).g, 1.0f);
}

// Of fewer replicas, the noise is less certain.
TEST(StatisticalDenoiserTest, TheBoundGrowsWithFewerReplicas) {
    for (const auto& [replicas, bound] :
         {std::pair(2, 9.925), std::pair(3, 4.604), std::pair(7, 3.055), std::pair(8, 2.977)}) {
        const auto step = static_cast<float>(bound * std::sqrt(2.0) * 0.1);
        const NoisyImage above = withError(edge(glm::vec3(1.001f * step)), 0.1f, replicas);
        EXPECT_EQ(denoised(above).pixels, above.color.pixels) << replicas;
    }
    // One pixel that differs by 5 standard errors: its patches do not.
    Image dot = constantImage(kWidth, kHeight, glm::vec3(1.0f));
    dot.at(20, 20) = glm::vec3(1.5f);
    EXPECT_EQ(denoised(withError(dot, 0.1f, 8)).at(20, 20).g, 1.5f);
    EXPECT_LT(denoised(withError(dot, 0.1f, 3)).at(20, 20).g, 1.05f);
}

// The weights are symmetric, so a slope has no bias where the square is whole.
TEST(StatisticalDenoiserTest, KeepsASlope) {
    constexpr float kSlope = 0.01f;
    Image slope(kWidth, kHeight);
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x)
            slope.at(x, y) = glm::vec3(1.0f + kSlope * float(x));
    const Image image = denoised(withError(slope, 0.1f));
    for (uint32_t x = 0; x < kWidth; ++x) {
        const double bias = isInside(x, 20) ? 1e-6 : double{kSlope} * kRadius;
        EXPECT_NEAR(image.at(x, 20).g, slope.at(x, 20).g, bias) << x;
    }
}

TEST(StatisticalDenoiserTest, FeaturesSeparateWhatColoursDoNot) {
    const NoisyImage noisy = withError(edge(glm::vec3(0.1f)), 0.1f);
    DenoiserFeatures albedo = noFeatures(noisy.color);
    DenoiserFeatures normal = noFeatures(noisy.color);
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = kWidth / 2; x < kWidth; ++x) {
            albedo.albedo.at(x, y).b = 0.1f; // five standard deviations
            normal.normal.at(x, y).r = 0.5f;
        }
    // Of each pixel on the other side, the weight is exp(-12.5) = 4e-6.
    for (const DenoiserFeatures& features : {albedo, normal}) {
        const Image image = StatisticalDenoiser(features, 1).run(noisy);
        for (uint32_t x = 0; x < kWidth; ++x)
            EXPECT_NEAR(image.at(x, 20).g, noisy.color.at(x, 20).g, 1e-6) << x;
    }
    EXPECT_GT(std::abs(denoised(noisy).at(kWidth / 2, 20).g - 1.1f), 0.01f);
}

// Rare bright samples: their light must not be lost where a few pixels reject them.
TEST(StatisticalDenoiserTest, KeepsTheMeanOfThePicture) {
    const NoisyImage noisy =
        noisyImage(kWidth, kHeight, 8, 1, [](auto x, auto, auto, std::mt19937& random) {
            const double light = std::exponential_distribution(1.0)(random);
            const bool isRare = std::uniform_real_distribution()(random) < (x < 24 ? 0.3 : 0.01);
            return 0.1 + light + (isRare ? 20.0 * light : 0.0);
        });
    const Image image = denoised(noisy);
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(meanOf(image)[channel] / meanOf(noisy.color)[channel], 1.0, 1e-7);
    EXPECT_NE(image.pixels, noisy.color.pixels);
}

// A bright sample of one replica differs from its neighbours by one standard error, whatever they
// are: it is spread over them.
TEST(StatisticalDenoiserTest, SpreadsAFirefly) {
    NoisyImage noisy = withError(constantImage(kWidth, kHeight, glm::vec3(1.0f)), 0.0f);
    noisy.color.at(20, 20) = glm::vec3(1001.0f);
    noisy.standardError.at(20, 20) = glm::vec3(1000.0f);
    const Image image = denoised(noisy);
    EXPECT_LT(image.at(20, 20).g, 30.0f);
    EXPECT_NEAR(meanOf(image).g, meanOf(noisy.color).g, 1e-6);
}

TEST(StatisticalDenoiserTest, WithoutNoiseNothingChanges) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform;
    Image texture(kWidth, kHeight);
    for (glm::vec3& pixel : texture.pixels)
        pixel = {uniform(random), uniform(random), uniform(random)};
    EXPECT_EQ(denoised(withError(texture, 0.0f)).pixels, texture.pixels);
    const Image black(kWidth, kHeight);
    EXPECT_EQ(denoised(withError(black, 0.0f)).pixels, black.pixels);
}

TEST(StatisticalDenoiserTest, IsFiniteAtTheEndsOfTheRange) {
    for (const float value : {1e-45f, 1e-30f, 1.0f, 1e30f, std::numeric_limits<float>::max()}) {
        NoisyImage noisy = withError(edge(glm::vec3(0.0f)), value);
        for (glm::vec3& pixel : noisy.color.pixels)
            pixel *= value;
        noisy.color.at(3, 3) = glm::vec3(0.0f);
        for (const glm::vec3& pixel : denoised(noisy).pixels) {
            EXPECT_TRUE(std::isfinite(pixel.g)) << value;
            EXPECT_LE(pixel.g, value);
            EXPECT_GE(pixel.g, 0.0f);
        }
    }
    const NoisyImage onePixel = withError(constantImage(1, 1, glm::vec3(3.0f)), 1.0f);
    EXPECT_EQ(denoised(onePixel).pixels, onePixel.color.pixels);
}

TEST(StatisticalDenoiserTest, IsTheSameOnAnyNumberOfThreads) {
    const NoisyImage noisy =
        noisyImage(kWidth, kHeight, 8, 1, [](auto x, auto, auto, std::mt19937& random) {
            return std::normal_distribution(x < 20 ? 1.0 : 3.0, 1.0)(random);
        });
    const DenoiserFeatures features = noFeatures(noisy.color);
    EXPECT_EQ(StatisticalDenoiser(features, 1).run(noisy).pixels,
              StatisticalDenoiser(features, 5).run(noisy).pixels);
}

} // namespace
} // namespace calotype::test
