// calotype render --transparent: files, films and what does not go together.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/film_cli_test.h"
#include "image/exr.h"
#include "image/read_texel_image.h"

namespace calotype::test {
namespace {

/// A ball under a background, at the middle of the picture.
const std::string kBall = R"({
  "camera": { "position": [0, 0, 4], "fov": 40 },
  "film": { "width": 32, "height": 24, "filter": "gaussian" },
  "render": { "spp": 16, "max_bounces": 2 },
  "background": [0.25, 0.5, 1],
  "materials": { "grey": { "type": "diffuse", "color": 0.6 } },
  "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 0.8, "material": "grey" } ]
})";

class TransparentTest : public FilmTest {
protected:
    TransparentTest() { scene_ = folder_.write("ball.json", kBall); }

    Picture picture(const std::string& name, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = render(more);
        arguments.insert(arguments.end(), {"-o", folder_ / name});
        const ProgramResult result = runProgram(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return readExrPicture(folder_ / name);
    }
};

std::vector<float> alphaOf(const Picture& picture) {
    return {picture.alpha().begin(), picture.alpha().end()};
}

void expectBallWithAlpha(const Picture& picture) {
    const std::vector<float> alpha = alphaOf(picture);
    ASSERT_EQ(alpha.size(), 32u * 24u);
    EXPECT_EQ(alpha[0], 0.0f);
    EXPECT_EQ(picture.color.at(0, 0), glm::vec3(0.0f));
    EXPECT_EQ(alpha[12 * 32 + 16], 1.0f);
    EXPECT_GT(picture.color.at(16, 12).b, 0.1f);
    EXPECT_TRUE(std::ranges::any_of(alpha, [](float a) { return a > 0.2f && a < 0.8f; }));
}

TEST_F(TransparentTest, ExrFilesHaveAnAlphaChannel) {
    const Picture part = picture("a.exr", {"--transparent", "--stats", folder_ / "stats.json"});
    expectBallWithAlpha(part);
    EXPECT_TRUE(nlohmann::json::parse(readText(folder_ / "stats.json"))["transparent"]);
    EXPECT_TRUE(alphaOf(picture("whole.exr", {})).empty());
    scene_ = folder_.write("scene.json", std::string(kBall).replace(kBall.find("\"spp\""), 0,
                                                                    "\"transparent\": true, "));
    EXPECT_EQ(alphaOf(picture("b.exr", {})), alphaOf(part));
    EXPECT_TRUE(alphaOf(picture("c.exr", {"--set", "/render/transparent=false"})).empty());
}

// The colour of the covered part, as the PNG specification demands.
TEST_F(TransparentTest, PngFilesHaveColorsThatAreNotMultiplied) {
    const std::string png = folder_ / "a.png";
    const Picture exr = picture("a.exr", {"--transparent", "-o", png});
    const std::vector<uint8_t> pixels = readTexelImage(readText(png), 64, png).bytes;
    ASSERT_EQ(pixels.size(), 4u * 32u * 24u);
    const std::vector<float> alpha = alphaOf(exr);
    size_t edges = 0;
    for (size_t i = 0; i < alpha.size(); ++i) {
        EXPECT_NEAR(pixels[4 * i + 3], 255.0f * alpha[i], 0.51f);
        if (alpha[i] < 0.3f || alpha[i] > 0.7f)
            continue;
        ++edges;
        const float straight = exr.color.pixels[i].b / alpha[i];
        const float encoded = 1.055f * std::pow(straight, 1.0f / 2.4f) - 0.055f;
        EXPECT_NEAR(pixels[4 * i + 2], 255.0f * std::clamp(encoded, 0.0f, 1.0f), 0.6f);
    }
    EXPECT_GT(edges, 4u);
}

TEST_F(TransparentTest, FilmsKeepAlpha) {
    const std::string whole = film("whole.film", {"--transparent", "--spp", "64"});
    const std::string first = film("1.film", {"--transparent", "--samples", "0:32"});
    const std::string second = film("2.film", {"--transparent", "--samples", "32:64"});
    const std::string both = folder_ / "both.film";
    const std::string merged = folder_ / "merged.exr";
    const ProgramResult result = runProgram({"merge", first, second, "-o", both, "-o", merged});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    expectSameFilm(whole, both);
    const Picture rendered = picture("rendered.exr", {"--transparent", "--spp", "64"});
    EXPECT_EQ(alphaOf(readExrPicture(merged)), alphaOf(rendered));
    const Picture resumed =
        picture("resumed.exr", {"--transparent", "--spp", "64", "--resume", first});
    EXPECT_EQ(alphaOf(resumed), alphaOf(rendered));
    EXPECT_EQ(resumed.color.pixels, rendered.color.pixels);
    const std::string opaque = film("opaque.film", {"--samples", "32:64"});
    expectFailure(runProgram({"merge", first, opaque, "-o", merged}), 3,
                  "its setting transparent is off, not on; leave out --transparent");
    expectFailure(runProgram(render({"--resume", opaque, "-o", merged, "--transparent"})), 3,
                  "its setting transparent is off, not on; leave out --transparent");
}

TEST_F(TransparentTest, GoesWithDenoisersPreviewsAdaptiveSamplesAndTheReference) {
    const std::string preview = folder_ / "preview.exr";
    const Picture plain = picture("a.exr", {"--transparent", "--spp", "128", "--preview-every",
                                            "20", "--preview-file", preview});
    expectBallWithAlpha(readExrPicture(preview));
    const Picture denoised =
        picture("b.exr", {"--transparent", "--spp", "128", "--denoise", "statistical"});
    EXPECT_EQ(alphaOf(denoised), alphaOf(plain)) << "alpha is not denoised";
    EXPECT_NE(denoised.color.pixels, plain.color.pixels);
    // The samples of an unfinished block count, too.
    for (const float alpha : alphaOf(picture("e.exr", {"--transparent", "--spp", "24"})))
        EXPECT_NEAR(24.0f * alpha, std::round(24.0f * alpha), 1e-4f);
    expectBallWithAlpha(picture("c.exr", {"--transparent", "--adaptive", "--spp", "64"}));
    expectBallWithAlpha(picture("d.exr", {"--transparent", "--device", "reference"}));
}

} // namespace
} // namespace calotype::test
