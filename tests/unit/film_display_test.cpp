#include "film/display_transform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "base/error.h"
#include "film/write_picture.h"
#include "image/exr.h"
#include "image/pfm.h"
#include "image/srgb.h"
#include "support/scratch_folder.h"

namespace calotype {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr ToneMap kToneMaps[] = {ToneMap::None, ToneMap::Neutral, ToneMap::Reinhard, ToneMap::Agx};

glm::ivec3 shown(const glm::vec3& radiance, const DisplayTransform& transform = {}) {
    Image image(1, 1);
    image.at(0, 0) = radiance;
    return glm::ivec3(toDisplay(image, transform).at(0, 0));
}

TEST(SrgbTest, FollowsTheStandardOnBothPieces) {
    EXPECT_FLOAT_EQ(srgbFromLinear(0.001f), 0.01292f);
    EXPECT_FLOAT_EQ(srgbFromLinear(0.0031308f), 0.040449936f);
    EXPECT_FLOAT_EQ(srgbFromLinear(0.0032f), 0.041323359f);
    EXPECT_FLOAT_EQ(srgbFromLinear(0.5f), 0.735356983f); // 1.055 * 0.5^(1/2.4) - 0.055
    EXPECT_FLOAT_EQ(srgbFromLinear(1.0f), 1.0f);
}

TEST(DisplayTransformTest, RoundsToTheNearestLevel) {
    EXPECT_EQ(shown({0.0f, 0.0031308f, 0.18f}), glm::ivec3(0, 10, 118)); // 10.31, 117.65
    EXPECT_EQ(shown({0.5f, 0.999f, 1.0f}), glm::ivec3(188, 255, 255));   // 187.52, 254.89
    EXPECT_EQ(shown({0.00015f, 0.00016f, 2.0f}), glm::ivec3(0, 1, 255)); // 0.494, 0.527
}

// The colour of a pixel's covered part is shown as it would be on an opaque pixel, by every tone
// map: the PNG specification (section 12.9) has colours that are not multiplied by alpha.
TEST(DisplayTransformTest, DividesByAlphaFirst) {
    const std::vector<float> alpha = {0.25f, 1.0f, 0.0f};
    for (const ToneMap toneMap : kToneMaps) {
        const DisplayTransform transform{1.0f, toneMap};
        const glm::vec3 color(0.6f, 0.1f, 1.5f);
        Image image(3, 1);
        image.pixels = {0.25f * color, color, {0.5f, 0.5f, 0.5f}};
        const Rgb8Image display = toDisplay(image, transform, alpha);
        EXPECT_EQ(glm::ivec3(display.at(0, 0)), shown(color, transform));
        EXPECT_EQ(glm::ivec3(display.at(1, 0)), shown(color, transform));
        EXPECT_EQ(glm::ivec3(display.at(2, 0)), glm::ivec3(0)) << "what a denoiser left there";
    }
    EXPECT_EQ(alphaLevels(std::vector<float>{0.0f, 0.25f, 0.5f, 1.0f, 1.5f, -1.0f, NAN}),
              (std::vector<uint8_t>{0, 64, 128, 255, 255, 0, 0})); // alpha is not encoded as sRGB
}

TEST(DisplayTransformTest, ExposesInStops) {
    EXPECT_EQ(shown({0.25f, 0.09f, 0.0f}, {1.0f}), shown({0.5f, 0.18f, 0.0f}));
    EXPECT_EQ(shown({2.0f, 0.72f, 0.0f}, {-2.0f}), shown({0.5f, 0.18f, 0.0f}));
}

TEST(DisplayTransformTest, ShowsWhatIsNoLightAsBlack) {
    for (ToneMap toneMap : kToneMaps)
        for (float stops : {-1000.0f, 0.0f, 1000.0f}) {
            const DisplayTransform transform{stops, toneMap};
            EXPECT_EQ(shown({NAN, kInfinity, -kInfinity}, transform), glm::ivec3(0));
            EXPECT_EQ(shown({-1.0f, -kLargest, 0.0f}, transform), glm::ivec3(0));
        }
}

TEST(DisplayTransformTest, ShowsTheLargestFloatAsWhite) {
    for (ToneMap toneMap : kToneMaps)
        for (float stops : {0.0f, 1000.0f})
            EXPECT_EQ(shown(glm::vec3(kLargest), {stops, toneMap}), glm::ivec3(255));
}

TEST(ToneMapTest, IsFoundByName) {
    EXPECT_EQ(toneMapFromName("none"), ToneMap::None);
    EXPECT_EQ(toneMapFromName("neutral"), ToneMap::Neutral);
    EXPECT_EQ(toneMapFromName("reinhard"), ToneMap::Reinhard);
    EXPECT_EQ(toneMapFromName("agx"), ToneMap::Agx);
    EXPECT_EQ(toneMapFromName("Neutral"), std::nullopt);
    EXPECT_EQ(toneMapFromName(""), std::nullopt);
}

TEST(ToneMapTest, KeepsBlackAndNeverDarkensWithMoreLight) {
    for (ToneMap toneMap : kToneMaps)
        for (const glm::vec3& color : {glm::vec3(1.0f), glm::vec3(1.0f, 0.5f, 0.1f),
                                       glm::vec3(0.0f, 0.2f, 1.0f), glm::vec3(0.0f, 1.0f, 0.0f)}) {
            EXPECT_EQ(applyToneMap(toneMap, glm::vec3(0.0f)), glm::vec3(0.0f));
            glm::vec3 previous(0.0f);
            for (float stops = -12.0f; stops <= 12.0f; stops += 0.01f) {
                const glm::vec3 mapped = applyToneMap(toneMap, color * std::exp2(stops));
                for (int channel = 0; channel < 3; ++channel) {
                    // A few roundings of values below one may differ between neighbours.
                    EXPECT_GE(mapped[channel], previous[channel] - 3e-7f) << stops;
                    EXPECT_LE(mapped[channel], 1.0f);
                }
                previous = mapped;
            }
        }
}

TEST(ToneMapTest, NeutralMatchesItsSpecification) {
    const auto map = [](const glm::vec3& color) { return applyToneMap(ToneMap::Neutral, color); };
    // Toe: 6.25 * 0.04^2; beyond it the smallest channel loses 0.04, and so do the others.
    EXPECT_NEAR(map(glm::vec3(0.04f)).g, 0.01f, 1e-7);
    EXPECT_NEAR(map({0.5f, 0.3f, 0.2f}).r, 0.46f, 1e-7);
    EXPECT_NEAR(map({0.5f, 0.3f, 0.2f}).b, 0.16f, 1e-7);
    // Grey 2: the peak 1.96 becomes 1 - 0.24^2 / (1.96 + 0.24 - 0.76) = 0.96.
    EXPECT_NEAR(map(glm::vec3(2.0f)).r, 0.96f, 1e-6);
    // Red 1.24: the peak becomes 1 - 0.0576 / 0.72 = 0.92, of which the other channels get the
    // share 1 - 1 / (0.15 * 0.32 + 1) = 0.0458015.
    EXPECT_NEAR(map({1.24f, 0.0f, 0.0f}).r, 0.92f, 1e-6);
    EXPECT_NEAR(map({1.24f, 0.0f, 0.0f}).g, 0.0421374f, 1e-6);
}

TEST(ToneMapTest, ReinhardKeepsTheRatiosOfChannels) {
    EXPECT_EQ(applyToneMap(ToneMap::Reinhard, {3.0f, 1.5f, 0.0f}), glm::vec3(0.75f, 0.375f, 0.0f));
}

// The displayed value, encoded for a display of gamma 2.2.
double encoded(const glm::vec3& mapped, int channel) {
    return std::pow(double(mapped[channel]), 1.0 / 2.2);
}

TEST(ToneMapTest, AgxMatchesItsDefinition) {
    const auto map = [](const glm::vec3& color) { return applyToneMap(ToneMap::Agx, color); };
    // Greys: middle grey becomes a half, with slope 2 over 16.5 stops; the ends, and beyond them.
    EXPECT_NEAR(encoded(map(glm::vec3(0.18f)), 1), 0.5, 1e-6);
    const float little = std::exp2(0.01f);
    EXPECT_NEAR(encoded(map(glm::vec3(0.18f * little)), 0), 0.5 + 2.0 * 0.01 / 16.5, 1e-5);
    EXPECT_EQ(map(glm::vec3(0.18f / 1030.0f)), glm::vec3(0.0f));
    EXPECT_GT(map(glm::vec3(0.18f / 1000.0f)).r, 0.0f);
    EXPECT_NEAR(map(glm::vec3(0.18f * 90.50967f)).b, 1.0f, 1e-6); // 2^6.5
    EXPECT_NEAR(map(glm::vec3(1e6f)).b, 1.0f, 1e-6);
    // The formula's power at five stops below and at three above, by hand: 4^3 - 0.606061^-3 is
    // 59.507875, and 4^3.25 - 0.393939^-3.25 is 69.862789.
    EXPECT_NEAR(encoded(map(glm::vec3(0.18f / 32.0f)), 0), 0.0623646, 1e-6);
    EXPECT_NEAR(encoded(map(glm::vec3(0.18f * 8.0f)), 0), 0.8375099, 1e-6);
    // Red 1: the shares are 0.6443, 1.192 and 1.2032 of 3.0395, so the channels become 0.842395,
    // 0.042395 and 0.042395; after the curve 0.761784 and 0.256540; after the way back as below.
    const glm::vec3 red = map({1.0f, 0.0f, 0.0f});
    EXPECT_NEAR(encoded(red, 0), 0.861320, 1e-5);
    EXPECT_NEAR(encoded(red, 1), 0.229765, 1e-5);
    EXPECT_EQ(red.g, red.b);
    EXPECT_GT(map({1e5f, 0.0f, 0.0f}).g, 0.99f);
}

TEST(ExposureTest, MakesTheKeyMiddleGrey) {
    Image image(64, 32);
    for (const float light : {0.18f, 18.0f, 1.8e-5f}) {
        std::ranges::fill(image.pixels, glm::vec3(light));
        EXPECT_NEAR(exposureOf(image), std::log2(0.18f / light), 0.0501f);
        EXPECT_EQ(toDisplay(image, {std::nullopt}).pixels,
                  toDisplay(image, {exposureOf(image)}).pixels);
    }
    // Half of the picture is 2 stops above the other: the mean is 1 stop above.
    for (uint32_t y = 0; y < 32; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            image.at(x, y) = glm::vec3(x < 32 ? 0.18f : 0.72f);
    EXPECT_EQ(exposureOf(image), -1.0f);
    // Black surroundings do not count, and neither does a pixel that is not finite.
    for (uint32_t y = 0; y < 32; ++y)
        for (uint32_t x = 0; x < 32; ++x)
            image.at(x, y) = glm::vec3(0.0f);
    image.at(63, 0) = glm::vec3(NAN);
    EXPECT_EQ(exposureOf(image), -2.0f);
}

// One of 100 blocks is 2^30 times as bright as all others: it adds 0.3 stops to the mean.
TEST(ExposureTest, IsNotDecidedByALamp) {
    Image image(160, 160);
    std::ranges::fill(image.pixels, glm::vec3(0.18f));
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = 0; x < 16; ++x)
            image.at(x, y) = glm::vec3(0.18f * 0x1p30f);
    EXPECT_FLOAT_EQ(exposureOf(image), -0.3f);
}

TEST(ExposureTest, IsZeroForABlackPicture) { EXPECT_EQ(exposureOf(Image(20, 20)), 0.0f); }

// A hundredth of the pixels has all the light, as in the first samples of a path tracer.
TEST(ExposureTest, DoesNotDependOnNoise) {
    Image noisy(160, 160);
    for (size_t i = 0; i < noisy.pixels.size(); i += 16)
        noisy.pixels[i + i / 160 % 16] = glm::vec3(16.0f * 0.18f);
    EXPECT_NEAR(exposureOf(noisy), 0.0f, 0.1f);
}

TEST(WritePictureTest, PicksTheFormatByExtension) {
    Image image(2, 1);
    image.pixels = {{0.1f, 0.2f, NAN}, {3.0f, 0.0f, -1.0f}};
    const test::ScratchFolder folder;
    for (const char* name : {"a.png", "a.exr", "a.PFM"})
        writePicture(folder / name, {image}, {});
    EXPECT_EQ(test::readBytes(folder / "a.png").substr(1, 3), "PNG");
    EXPECT_EQ(readExr(folder / "a.exr").at(1, 0), image.at(1, 0));
    EXPECT_EQ(readPfm(folder / "a.PFM").at(1, 0), image.at(1, 0));
    EXPECT_THROW(writePicture(folder / "a.jpg", {image}, {}), OutputError);
    EXPECT_THROW(writePicture(folder / "missing/a.png", {image}, {}), OutputError);
    EXPECT_EQ(folder.entries(), 3u);
}

} // namespace
} // namespace calotype
