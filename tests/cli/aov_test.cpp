// What `calotype render --aov` writes and says.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputFile.h>

#include "cli/cli_test.h"
#include "film/error_estimate.h"
#include "film/film_file.h"
#include "image/exr.h"
#include "image/layers.h"
#include "image/pfm.h"

namespace calotype::test {
namespace {

const std::string kAllLayers = "albedo,normal,depth,position,primitive,uv";

using AovTest = CliTest;

TEST_F(AovTest, LayersGoIntoEveryExrBesideThePicture) {
    const std::string first = folder_ / "a.exr";
    const std::string second = folder_ / "b.EXR";
    const std::string pfm = folder_ / "c.pfm";
    const ProgramResult result =
        runProgram({"render", scene_, "-o", pfm, "-o", first, "-o", second, "--aov", kAllLayers});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(readText(first), readText(second));
    EXPECT_EQ(readExr(first).pixels, readPfm(pfm).pixels);
    const FirstHitImage hits = readFirstHits(first);
    ASSERT_EQ(hits.width, 32u);
    ASSERT_EQ(hits.height, 24u);
    // The camera looks at the ball's middle, and over the floor's far edge at nothing.
    const FirstHit& ball = hits.at(16, 12);
    EXPECT_EQ(ball.primitive, 2u);
    EXPECT_EQ(ball.albedo, glm::vec3(0.6f));
    EXPECT_NEAR(ball.depth, std::hypot(4.0, 0.5) - 0.5, 0.01);
    EXPECT_GT(ball.normal.z, 0.95f);
    EXPECT_NEAR(ball.position.z, 0.5, 0.02);
    EXPECT_NEAR(ball.uv.x, 0.25, 0.02); // z is a quarter turn from x
    EXPECT_EQ(hits.at(0, 0).primitive, kNoPrimitive);
    EXPECT_TRUE(std::isinf(hits.at(0, 0).depth));
    const FirstHit& floor = hits.at(16, 23);
    EXPECT_LT(floor.primitive, 2u);
    EXPECT_NEAR(floor.uv.y, (3.0 - floor.position.z) / 6.0, 1e-5); // though there is no texture
}

// Layers need texture coordinates on the device. That must not change the picture.
TEST_F(AovTest, PictureIsTheSameWithAndWithoutLayers) {
    const std::string with = folder_ / "with.exr";
    const std::string without = folder_ / "without.exr";
    EXPECT_EQ(runProgram({"render", scene_, "-o", with, "--aov", "uv"}).exitCode, 0);
    EXPECT_EQ(runProgram({"render", scene_, "-o", without}).exitCode, 0);
    EXPECT_EQ(readExr(with).pixels, readExr(without).pixels);
}

TEST_F(AovTest, CropsAndPreviewsHaveTheirLayers) {
    const std::string whole = folder_ / "whole.exr";
    const std::string crop = folder_ / "crop.exr";
    const std::string preview = folder_ / "preview.exr";
    EXPECT_EQ(runProgram({"render", scene_, "-o", whole, "--aov", kAllLayers}).exitCode, 0);
    EXPECT_EQ(runProgram({"render", scene_, "-o", crop, "--aov", "primitive,position", "--crop",
                          "9,5,15,11", "--preview-every", "2", "--preview-file", preview})
                  .exitCode,
              0);
    const FirstHitImage all = readFirstHits(whole);
    for (const std::string& path : {crop, preview}) {
        const FirstHitImage part = readFirstHits(path);
        ASSERT_EQ(part.width, 15u);
        ASSERT_EQ(part.height, 11u);
        for (uint32_t y = 0; y < part.height; ++y)
            for (uint32_t x = 0; x < part.width; ++x) {
                EXPECT_EQ(part.at(x, y).primitive, all.at(x + 9, y + 5).primitive);
                EXPECT_EQ(part.at(x, y).position, all.at(x + 9, y + 5).position);
                EXPECT_EQ(part.at(x, y).normal, glm::vec3(0.0f));
            }
    }
}

// The errors are those of the film that the render keeps.
TEST_F(AovTest, ErrorsAreTheFilms) {
    const std::string exr = folder_ / "a.exr";
    const std::string film = folder_ / "a.film";
    ASSERT_EQ(
        runProgram({"render", scene_, "-o", exr, "--aov", "error", "--spp", "136", "--film", film})
            .exitCode,
        0);
    const KeptFilm kept = readFilm(film);
    const std::vector<PixelError> expected = pixelErrors(kept.film);
    Imf::InputFile file(exr.c_str());
    std::vector<PixelError> errors(expected.size());
    Imf::FrameBuffer buffer;
    constexpr size_t kStride = sizeof(PixelError);
    buffer.insert("error.SE", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(errors.data()),
                                         kStride, kStride * kept.film.width()));
    buffer.insert("error.CI95", Imf::Slice(Imf::FLOAT,
                                           reinterpret_cast<char*>(errors.data()) +
                                               offsetof(PixelError, interval),
                                           kStride, kStride * kept.film.width()));
    file.setFrameBuffer(buffer);
    file.readPixels(0, static_cast<int>(kept.film.height()) - 1);
    size_t noisy = 0;
    for (size_t i = 0; i < errors.size(); ++i) {
        EXPECT_EQ(errors[i].standardError, expected[i].standardError);
        EXPECT_EQ(errors[i].interval, expected[i].interval);
        noisy += errors[i].standardError > 0.0f && errors[i].interval > errors[i].standardError;
    }
    EXPECT_GT(noisy, errors.size() / 4); // what shows the floor or the ball
}

TEST_F(AovTest, MistakesAreNamed) {
    const std::string exr = folder_ / "a.exr";
    const auto aov = [&](const std::string& list, const std::string& out) {
        return runProgram({"render", scene_, "-o", out, "--aov", list});
    };
    expectFailure(aov("normal", folder_ / "a.png"), 2, ".exr");
    expectFailure(aov("albedo,normals", exr), 2, "did you mean \"normal\"?");
    expectFailure(aov("shadow", exr), 2, "\"albedo\", \"normal\", \"depth\", \"position\"");
    expectFailure(aov("", exr), 2, "--aov");
    expectFailure(aov("uv,", exr), 2, "--aov");
    expectFailure(aov("uv,depth,uv", exr), 2, "\"uv\" twice");
    expectFailure(aov("error,uv,error", exr), 2, "\"error\" twice");
    expectFailure(aov("errors", exr), 2, "did you mean \"error\"?");
    expectFailure(aov("error", folder_ / "a.pfm"), 2, ".exr");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
}

} // namespace
} // namespace calotype::test
