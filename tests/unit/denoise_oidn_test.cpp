#include "denoise/oidn_denoiser.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/test_denoiser.h"

namespace calotype {
namespace {

constexpr uint32_t kSide = 96;

/// A bright square on grey, and its features.
Image truth() {
    Image image(kSide, kSide);
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x)
            image.at(x, y) =
                x >= 32 && x < 64 && y >= 32 && y < 64 ? glm::vec3(4.0f) : glm::vec3(0.5f);
    return image;
}

DenoiserFeatures featuresOfTruth() {
    DenoiserFeatures features{truth(), Image(kSide, kSide)};
    for (size_t i = 0; i < features.albedo.pixels.size(); ++i) {
        features.albedo.pixels[i] *= 0.2f;
        features.normal.pixels[i] = {0.0f, 0.0f, 1.0f};
    }
    return features;
}

/// The truth times noise of mean 1.
Image noisy(uint32_t seed) {
    std::mt19937 random(seed);
    std::exponential_distribution<float> noise(1.0f);
    Image image = truth();
    for (glm::vec3& pixel : image.pixels)
        pixel *= noise(random);
    return image;
}

double meanSquaredError(const Image& image) {
    const Image exact = truth();
    double sum = 0.0;
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::dvec3 error(image.pixels[i] - exact.pixels[i]);
        sum += error.g * error.g / static_cast<double>(image.pixels.size());
    }
    return sum;
}

/// Skipped where the library is not installed.
class OidnTest : public testing::Test {
protected:
    void SetUp() override {
        if (!library_)
            GTEST_SKIP() << "Open Image Denoise is not installed";
    }

    std::unique_ptr<const OidnLibrary> library_ = test::testDenoiser();
};

TEST_F(OidnTest, RemovesNoise) {
    const DenoiserFeatures features = featuresOfTruth();
    OidnDenoiser denoiser(*library_, &features, noisy(1), 0);
    EXPECT_LT(meanSquaredError(denoiser.run({noisy(1), {}, 0})), 0.02 * meanSquaredError(noisy(1)));
    EXPECT_EQ(denoiser.name().rfind("Open Image Denoise 2.", 0), 0u) << denoiser.name();
}

// Cross-validation compares pictures that went through the same function.
TEST_F(OidnTest, DependsOnThePictureAlone) {
    const DenoiserFeatures features = featuresOfTruth();
    OidnDenoiser denoiser(*library_, &features, noisy(1), 0);
    const Image first = denoiser.run({noisy(2), {}, 0});
    Image bright = noisy(3);
    for (glm::vec3& pixel : bright.pixels)
        pixel *= 100.0f;
    denoiser.run({bright, {}, 0});
    EXPECT_EQ(denoiser.run({noisy(2), {}, 0}).pixels, first.pixels);
    OidnDenoiser other(*library_, &features, noisy(1), 1);
    EXPECT_EQ(other.run({noisy(2), {}, 0}).pixels, first.pixels) << "with one thread";
}

/// A wave times noise of mean 1, as a part of a picture of `width` and more.
Image noisyWave(uint32_t width, uint32_t height) {
    Image image(width, height);
    for (uint32_t y = 0; y < height; ++y) {
        std::mt19937 random(y); // so that a row begins like the row of a wider picture
        std::exponential_distribution<float> noise(1.0f);
        for (uint32_t x = 0; x < width; ++x)
            image.at(x, y) = glm::vec3((1.0f + std::sin(0.03f * float(x + y))) * noise(random));
    }
    return image;
}

// A picture of 1664 x 1024 pixels takes two tiles, a part of it one. Farther from its edge than a
// pixel can depend on, both are the same but for the order of sums.
TEST_F(OidnTest, SlowTilesLeaveNoTrace) {
    constexpr uint32_t kHeight = 1024;
    constexpr uint32_t kReach = 128;
    const auto denoised = [&](uint32_t width) {
        Image grey(width, kHeight);
        std::ranges::fill(grey.pixels, glm::vec3(1.0f)); // so that both have the same scale
        return OidnDenoiser(*library_, nullptr, grey, 0).run({noisyWave(width, kHeight), {}, 0});
    };
    const Image whole = denoised(1664);
    const Image part = denoised(1024);
    double largest = 0.0;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < 1024 - kReach; ++x)
            largest = std::max<double>(largest, std::abs(whole.at(x, y).g - part.at(x, y).g));
    EXPECT_LT(largest, 1e-4);
    EXPECT_NE(whole.at(1023, 500), part.at(1023, 500));
}

TEST(OidnLibraryTest, SaysHowToGetIt) {
    std::string message;
    try {
        const OidnLibrary library("/nowhere");
    } catch (const SettingError& error) {
        message = error.what();
    }
    EXPECT_NE(message.find("/nowhere"), std::string::npos) << message;
    EXPECT_NE(message.find("pip install pyoidn"), std::string::npos) << message;
}

TEST(OidnLibraryTest, RefusesALibraryThatIsAnother) {
    std::string message;
    try {
        const OidnLibrary library("libz.so.1");
    } catch (const SettingError& error) {
        message = error.what();
    }
    EXPECT_NE(message.find("'libz.so.1' lacks functions"), std::string::npos) << message;
}

TEST(ExposureTest, BringsTheGeometricMeanToMiddleGrey) {
    Image image(32, 16); // two blocks
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = 0; x < 32; ++x)
            image.at(x, y) = glm::vec3(x < 16 ? 0.5f : 8.0f);
    EXPECT_NEAR(exposureFor(image), 0.18 / 2.0, 1e-6);
    EXPECT_EQ(exposureFor(Image(3, 3)), 1.0f);
}

} // namespace
} // namespace calotype
