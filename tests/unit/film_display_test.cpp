#include "film/display_transform.h"

#include <cmath>
#include <limits>

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
constexpr ToneMap kToneMaps[] = {ToneMap::None, ToneMap::Neutral, ToneMap::Reinhard};

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
