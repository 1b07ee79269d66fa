// calotype render --denoise statistical, where there is no library.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "image/exr.h"
#include "support/paths.h"

namespace calotype::test {
namespace {

class StatisticalDenoiseTest : public CliTest {
protected:
    ProgramResult run(const std::vector<std::string>& arguments) {
        ProgramOptions options;
        options.environment["CALOTYPE_OIDN"] = "/nowhere";
        return runProgram(arguments, options);
    }

    ProgramResult render(const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"render", scene_, "--denoise", "statistical"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }

    nlohmann::json statistics() const { return nlohmann::json::parse(readText(stats_)); }

    std::string picture_ = folder_ / "a.exr";
    std::string stats_ = folder_ / "stats.json";
};

std::vector<float> greenOf(const Picture& picture) {
    std::vector<float> green;
    for (const glm::vec3& pixel : picture.color.pixels)
        green.push_back(pixel.g);
    return green;
}

/// The mean distance of green, relative to that of the first.
double distance(const std::vector<float>& a, const std::vector<float>& b) {
    double difference = 0.0;
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) {
        difference += std::abs(a[i] - b[i]);
        sum += a[i];
    }
    return difference / sum;
}

TEST_F(StatisticalDenoiseTest, StatesItsErrorWithoutTheLibrary) {
    scene_ = std::string(kProjectFolder) + "/scenes/cornell-box.json"; // whose error is trusted
    const ProgramResult result =
        render({"-o", picture_, "--spp", "128", "--stats", stats_, "--size", "48x48"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto json = statistics();
    EXPECT_EQ(json["denoise"], "statistical");
    EXPECT_GT(json["denoised_error"], 0.0);
    EXPECT_LT(json["denoised_error"], json["error"]["relative"]);
    EXPECT_LT(json["denoised_error"], json["denoised_bound"]);
    const Picture picture = readExrPicture(picture_);
    ASSERT_EQ(picture.channels.size(), 3u);
    EXPECT_NE(std::get<std::vector<float>>(picture.channels[1].pixels)[1000],
              picture.color.pixels[1000].g);
}

TEST_F(StatisticalDenoiseTest, IsTheSameByTheReference) {
    scene_ = std::string(kProjectFolder) + "/scenes/cornell-box.json";
    std::vector<std::vector<float>> clean;
    std::vector<float> noisy;
    for (const char* device : {"", "reference"}) {
        std::vector<std::string> options = {"-o", picture_, "--spp", "48", "--size", "20x20", "-q"};
        if (*device)
            options.insert(options.end(), {"--device", device});
        const ProgramResult result = render(options);
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        const Picture picture = readExrPicture(picture_);
        ASSERT_EQ(picture.channels.size(), 3u);
        noisy = std::get<std::vector<float>>(picture.channels[1].pixels);
        clean.push_back(greenOf(picture));
    }
    // Both have the same paths, but for a few that rounding turns another way.
    EXPECT_LT(distance(clean[0], clean[1]), 0.002);
    EXPECT_GT(distance(clean[1], noisy), 0.01);
}

TEST_F(StatisticalDenoiseTest, WarnsOfTooFewSamples) {
    for (const char* samples : {"5", "47"}) {
        const ProgramResult result = render({"-o", picture_, "--spp", samples, "--stats", stats_});
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_NE(result.errors.find("needs at least 48 samples per pixel"), std::string::npos)
            << result.errors;
        EXPECT_TRUE(statistics()["denoised_error"].is_null());
        EXPECT_TRUE(readExrPicture(picture_).channels.empty()) << "it is not denoised";
    }
}

// Without a device, on the CPU.
TEST_F(StatisticalDenoiseTest, MergeAndDenoiseDoSoOfTheFilm) {
    scene_ = std::string(kProjectFolder) + "/scenes/cornell-box.json";
    const std::string film = folder_ / "a.film";
    ASSERT_EQ(render({"-o", picture_, "--film", film, "--spp", "64", "--size", "20x20"}).exitCode,
              0);
    const std::string merged = folder_ / "b.exr";
    const ProgramResult result = run({"merge", film, "-o", merged, "--denoise", "statistical"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_LT(distance(greenOf(readExrPicture(picture_)), greenOf(readExrPicture(merged))), 1e-4);
    const std::string denoised = folder_ / "c.exr";
    ASSERT_EQ(run({"denoise", film, "-o", denoised, "--denoise", "statistical"}).exitCode, 0);
    EXPECT_TRUE(readText(denoised) == readText(merged));
    expectFailure(run({"denoise", merged, "-o", denoised, "--denoise", "statistical"}), 2,
                  "has no replicas");
    expectFailure(run({"denoise", film, "-o", denoised, "--denoise", "off"}), 2, "nothing to do");
    ASSERT_EQ(render({"--film", film, "--spp", "16", "--overwrite", "--size", "20x20"}).exitCode,
              0);
    expectFailure(run({"merge", film, "-o", merged, "--denoise", "statistical"}), 3,
                  "needs at least 48 samples per pixel");
}

TEST_F(StatisticalDenoiseTest, PreviewsStayAsTheyAre) {
    const std::string preview = folder_ / "preview.exr";
    ASSERT_EQ(
        render({"-o", picture_, "--spp", "64", "--preview-every", "32", "--preview-file", preview})
            .exitCode,
        0);
    EXPECT_TRUE(readExrPicture(preview).channels.empty());
}

} // namespace
} // namespace calotype::test
