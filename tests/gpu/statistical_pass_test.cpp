#include "render/statistical_pass.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "denoise/statistical_denoiser.h"
#include "support/gpu_test.h"
#include "support/noisy_image.h"

// The kernels of the statistical denoiser against the same in double precision.

namespace calotype::test {
namespace {

class StatisticalPassTest : public GpuTest {};

/// A pattern, with more noise from a column on: those pixels are mixed with more of the others.
NoisyImage noisyPicture(uint32_t width, uint32_t height, uint32_t noisyFrom = 20) {
    return noisyImage(width, height, 8, 7, [&](auto x, auto y, auto channel, std::mt19937& random) {
        const double value = (x / 12 + y / 15) % 2 == 0 ? 1.0 : 1.5 + 0.2 * channel;
        return std::normal_distribution(value, x >= noisyFrom ? 1.5 * value : 0.5)(random);
    });
}

DenoiserFeatures featuresOf(const Image& image) {
    DenoiserFeatures features = noFeatures(image);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            features.albedo.at(x, y) = glm::vec3(0.5f + 0.01f * float((x / 7 + y / 9) % 3));
            features.normal.at(x, y) = {std::sin(0.05f * float(x)), std::cos(0.05f * float(x)),
                                        0.0f};
        }
    return features;
}

float largest(const Image& image) {
    float most = 0.0f;
    for (const glm::vec3& pixel : image.pixels)
        most = std::max({most, std::abs(pixel.r), std::abs(pixel.g), std::abs(pixel.b)});
    return most;
}

/// The largest distance of two pictures in any channel.
float distance(const Image& a, const Image& b) {
    Image difference(a.width, a.height);
    for (size_t i = 0; i < difference.pixels.size(); ++i)
        difference.pixels[i] = a.pixels[i] - b.pixels[i];
    return largest(difference);
}

// A weight exp(-x) is off by at most (3 + 2 x) 2^-23 of it for the function, as Vulkan requires,
// and by 4 x 2^-23 for the rounding of x. Weights of a large x are small, so the mean of x over the
// weights is about 2; so their sum is off by 15 x 2^-23 = 1.8e-6, and by as much again for the
// rounding of the sum. The change of a pixel is a mean, by these weights, of differences that are
// at most the range of the picture; the quotient of the weights doubles its error. That a
// difference is at the very bound, and decided in another way, would be seen: there is none in
// these pictures.
constexpr float kTolerance = 1e-5f;

void expectReference(uint32_t width, uint32_t height, uint32_t noisyFrom) {
    const NoisyImage noisy = noisyPicture(width, height, noisyFrom);
    const DenoiserFeatures features = featuresOf(noisy.color);
    const Image expected = StatisticalDenoiser(features, 0).run(noisy);
    const Image image = StatisticalPass(testDevice(), features, 2).run(noisy);
    EXPECT_GT(distance(expected, noisy.color), 0.5f);
    EXPECT_LT(distance(image, expected), kTolerance * largest(noisy.color));
}

TEST_F(StatisticalPassTest, AgreesWithTheReference) { expectReference(61, 45, 30); }

// Three windows side by side, from columns 0, 512 and 1024 on, each with margins.
TEST_F(StatisticalPassTest, AgreesAcrossWindows) { expectReference(1100, 9, 512); }

TEST_F(StatisticalPassTest, TakesOnePixel) {
    const NoisyImage noisy = withError(constantImage(1, 1, glm::vec3(3.0f)), 1.0f);
    EXPECT_EQ(StatisticalPass(testDevice(), noFeatures(noisy.color), 1).run(noisy).pixels,
              noisy.color.pixels);
}

TEST_F(StatisticalPassTest, DependsOnThePictureAlone) {
    const NoisyImage noisy = noisyPicture(40, 20);
    StatisticalPass pass(testDevice(), noFeatures(noisy.color), 1);
    const Image first = pass.run(noisy);
    NoisyImage other = noisyPicture(40, 20);
    std::ranges::reverse(other.color.pixels);
    pass.run(other);
    EXPECT_EQ(pass.run(noisy).pixels, first.pixels);
}

// The kernel works in a power of two of the picture's own range.
TEST_F(StatisticalPassTest, IsTheSameAtAnyBrightness) {
    const NoisyImage noisy = noisyPicture(40, 20);
    StatisticalPass pass(testDevice(), featuresOf(noisy.color), 1);
    const Image expected = pass.run(noisy);
    for (const float scale : {std::ldexp(1.0f, 100), std::ldexp(1.0f, -80)}) {
        NoisyImage scaled = noisy;
        for (size_t i = 0; i < scaled.color.pixels.size(); ++i) {
            scaled.color.pixels[i] *= scale;
            scaled.standardError.pixels[i] *= scale;
        }
        Image image = pass.run(scaled);
        for (glm::vec3& pixel : image.pixels)
            pixel /= scale;
        EXPECT_EQ(image.pixels, expected.pixels) << scale;
    }
}

} // namespace
} // namespace calotype::test
