// calotype render --denoise.
#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "film/film_file.h"
#include "image/exr.h"
#include "support/paths.h"
#include "support/test_denoiser.h"

namespace calotype::test {
namespace {

class DenoiseTest : public CliTest {
protected:
    ProgramResult render(const std::vector<std::string>& more, const ProgramOptions& options = {}) {
        std::vector<std::string> arguments = {"render", scene_, "--denoise", "oidn"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runProgram(arguments, options);
    }

    nlohmann::json statistics() const { return nlohmann::json::parse(readText(stats_)); }

    std::string picture_ = folder_ / "a.exr";
    std::string stats_ = folder_ / "stats.json";
};

TEST_F(DenoiseTest, SaysHowToGetTheLibraryBeforeItRenders) {
    ProgramOptions options;
    options.environment["CALOTYPE_OIDN"] = "/nowhere";
    const ProgramResult result = render({"-o", picture_, "--spp", "1000000"}, options);
    expectFailure(result, 2, "pip install pyoidn");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"scene.json"}));
}

// Of a picture without a stated error no one can say when it is good enough.
TEST_F(DenoiseTest, ATargetNeedsAPictureLargeEnoughToJudge) {
    expectFailure(render({"-o", picture_, "--target-error", "0.1", "--size", "48x32"}), 2,
                  "8 tiles of 16 x 16 pixels");
}

// By the error of the denoised picture, and of all samples; too few of them are said to be so.
TEST_F(DenoiseTest, GoesWithAdaptiveSampling) {
    scene_ = std::string(kProjectFolder) + "/scenes/cornell-box.json"; // whose error is trusted
    for (const std::vector<std::string>& end :
         {std::vector<std::string>{"--spp", "256"}, {"--target-error", "0.9"}}) {
        std::vector<std::string> arguments = {"-o",    picture_,  "--adaptive", "--size",
                                              "48x48", "--stats", stats_};
        arguments.insert(arguments.end(), end.begin(), end.end());
        const ProgramResult result = render(arguments, withFakeDenoiser());
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        const auto json = statistics();
        EXPECT_EQ(json["adaptive"], true);
        EXPECT_EQ(json["denoise"], "oidn");
        EXPECT_LT(json["denoised_error"], json["error"]["relative"]) << result.errors;
        EXPECT_EQ(json["ended_by"], end[0] == "--spp" ? "samples" : "target-error");
        EXPECT_EQ(readExrPicture(picture_).channels.size(), 3u) << "the layer noisy";
    }
    const ProgramResult few = runProgram({"render", scene_, "-o", picture_, "--adaptive", "--size",
                                          "16x16", "--denoise", "statistical", "--spp", "64"});
    EXPECT_EQ(few.exitCode, 0) << few.errors;
    EXPECT_NE(few.errors.find("needs at least 96 samples per pixel"), std::string::npos)
        << few.errors;
}

// The scene's choice, which the option overrides.
TEST_F(DenoiseTest, TheSceneCanAskForIt) {
    const std::vector<std::string> arguments = {
        "render", scene_, "-o", picture_, "--stats", stats_, "--set", "/render/denoise=\"oidn\""};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = arguments;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    ASSERT_EQ(runProgram(arguments, withFakeDenoiser()).exitCode, 0);
    EXPECT_EQ(statistics()["denoise"], "oidn");
    EXPECT_EQ(readExrPicture(picture_).channels.size(), 3u);
    ProgramOptions nowhere;
    nowhere.environment["CALOTYPE_OIDN"] = "/nowhere";
    ASSERT_EQ(runProgram(with({"--denoise", "off"}), nowhere).exitCode, 0);
    EXPECT_EQ(statistics()["denoise"], "off");
    EXPECT_EQ(readExrPicture(picture_).channels.size(), 0u);
    expectFailure(runProgram(arguments, nowhere), 2, "--denoise off renders without");
    expectFailure(runProgram({"render", scene_, "-o", picture_, "--set", "/render/denoise=1"}), 3,
                  "/render/denoise");
}

/// A model: squares of a material that lets all light pass, one behind the other.
std::string stackOfClearSquares(uint32_t squares) {
    std::string text = "mtllib clear.mtl\nusemtl clear\n";
    for (uint32_t i = 0; i < squares; ++i) {
        const std::string z = std::to_string(4.0 * i / squares);
        for (const char* corner : {"-9 -9 ", "9 -9 ", "9 9 ", "-9 9 "})
            text.append("v ").append(corner).append(z).append("\n");
        text += "f -4 -3 -2 -1\n";
    }
    return text;
}

// What the samples and the features lack is said, whatever becomes of the denoiser, and the picture
// is written.
TEST_F(DenoiseTest, AFailingDenoiserLosesNothing) {
    folder_.write("clear.mtl", "newmtl clear\nKd 0.5 0.5 0.5\nd 0\n");
    scene_ = folder_.write("stack.obj", stackOfClearSquares(1100));
    const ProgramResult result =
        render({"-q", "-o", picture_, "--film", folder_ / "a.film", "--spp", "16", "--size", "2x2",
                "--from", "0,0,9", "--look-at", "0,0,0"},
               withFakeDenoiser("fails"));
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.errors.find("calotype: Open Image Denoise failed: it was told to\n"),
              std::string::npos)
        << result.errors;
    EXPECT_NE(result.errors.find("warning: 128 rays of the averaged layers"), std::string::npos)
        << result.errors;
    EXPECT_EQ(readExrPicture(picture_).channels.size(), 0u);
    EXPECT_EQ(
        runProgram({"denoise", folder_ / "a.film", "-o", picture_}, withFakeDenoiser()).exitCode,
        0);
}

// A film of one part of the samples need not be denoised; the joined film is, where there is room.
TEST_F(DenoiseTest, AFilmAloneIsDenoisedLater) {
    const std::string film = folder_ / "a.film";
    const std::vector<std::string> arguments = {"--film", film, "--spp", "64", "--size", "32x32"};
    const ProgramResult alone = render(arguments, withFakeDenoiser("fails"));
    EXPECT_EQ(alone.exitCode, 0) << alone.errors;
    const ProgramResult later =
        runProgram({"denoise", film, "-o", picture_}, withFakeDenoiser("fails"));
    EXPECT_EQ(later.exitCode, 1) << "the fake denoiser fails where it runs";
    EXPECT_EQ(runProgram({"denoise", film, "-o", picture_}, withFakeDenoiser()).exitCode, 0);
}

// Without its denoiser the render would not know when to end.
TEST_F(DenoiseTest, AFailingDenoiserEndsARenderToATarget) {
    const ProgramResult result = render({"-q", "-o", picture_, "--film", folder_ / "a.film",
                                         "--target-error", "0.001", "--size", "64x64"},
                                        withFakeDenoiser("fails"));
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.errors.find("Open Image Denoise failed"), std::string::npos) << result.errors;
    EXPECT_EQ(readExr(picture_).width, 64u);
    EXPECT_EQ(readFilm(folder_ / "a.film").film.samplesPerPixel(), 128u);
}

TEST_F(DenoiseTest, ShowsThatItDenoises) {
    ProgramOptions options = withFakeDenoiser("slow");
    const ProgramResult asJson =
        render({"-o", picture_, "--spp", "48", "--progress", "json"}, options);
    ASSERT_EQ(asJson.exitCode, 0) << asJson.errors;
    const std::string start = "{\"stage\":\"denoising\",\"done\":";
    const size_t first = asJson.errors.find(start);
    EXPECT_EQ(asJson.errors.find(start + "0.0,\"spp\":48,"), first) << asJson.errors;
    EXPECT_NE(asJson.errors.find(start, first + 1), std::string::npos)
        << "1.2 s: " << asJson.errors;
    options.onTerminal = true;
    options.environment["TERM"] = "xterm";
    const ProgramResult shown = render({"-o", picture_, "--spp", "128"}, options);
    ASSERT_EQ(shown.exitCode, 0) << shown.errors;
    EXPECT_NE(shown.errors.find(" %  denoising"), std::string::npos) << shown.errors;
}

// Eight replicas and a picture take 2.7 s.
TEST_F(DenoiseTest, AnInterruptEndsDenoising) {
    ProgramOptions options = withFakeDenoiser("slow");
    const std::string film = folder_ / "a.film";
    bool isSent = false;
    options.whileRunning = [&](int pid, double) {
        std::error_code missing;
        if (!isSent && std::filesystem::file_size(film, missing) > 0 && !missing &&
            readFilm(film).film.samplesPerPixel() == 128) // and so denoising has begun, or will
            isSent = kill(pid, SIGINT) == 0;
    };
    const ProgramResult result = render({"-o", picture_, "--film", film, "--spp", "128"}, options);
    EXPECT_EQ(result.exitCode, 1) << result.errors;
    EXPECT_NE(result.errors.find("the picture is not denoised, because the render was stopped"),
              std::string::npos)
        << result.errors;
    EXPECT_EQ(readExrPicture(picture_).channels.size(), 0u);
}

// The first preview is denoised; the second follows at once, while denoising took 0.3 s.
TEST_F(DenoiseTest, DenoisesPreviewsWhereThatIsQuick) {
    const std::string preview = folder_ / "preview.exr";
    const auto previewOf = [&](const std::string& samples, const std::string& told) {
        const ProgramResult result = render({"-o", picture_, "--spp", samples, "--preview-every",
                                             "8", "--preview-file", preview, "-q"},
                                            withFakeDenoiser(told));
        EXPECT_EQ(result.exitCode, told == "fails" ? 1 : 0) << result.errors;
        EXPECT_EQ(result.errors.find("a preview is not denoised") != std::string::npos,
                  told == "fails");
        return readExrPicture(preview).channels.size();
    };
    EXPECT_EQ(previewOf("8", "slow"), 3u) << "the layer noisy";
    EXPECT_EQ(previewOf("16", "slow"), 0u);
    EXPECT_EQ(previewOf("8", "fails"), 0u);
}

/// Tests of the denoised picture are skipped where the library is not installed.
class DenoisedPictureTest : public DenoiseTest {
protected:
    void SetUp() override {
        if (!testDenoiser())
            GTEST_SKIP() << "Open Image Denoise is not installed";
    }
};

TEST_F(DenoisedPictureTest, StatesItsErrorAndKeepsTheSamples) {
    scene_ = std::string(kProjectFolder) + "/scenes/cornell-box.json"; // whose error is trusted
    const ProgramResult result =
        render({"-o", picture_, "--spp", "128", "--stats", stats_, "--size", "48x48"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto json = statistics();
    EXPECT_GT(json["denoised_error"], 0.0);
    EXPECT_LT(json["denoised_error"], json["error"]["relative"]);
    EXPECT_LT(json["denoised_error"], json["denoised_bound"]);
    EXPECT_EQ(json["denoise"], "oidn");
    EXPECT_NE(result.errors.find(", after denoising "), std::string::npos) << result.errors;

    // The layer of the samples is the picture without denoising.
    const Picture picture = readExrPicture(picture_);
    const ProgramResult plain =
        runProgram({"render", scene_, "-o", folder_ / "b.exr", "--spp", "128", "--size", "48x48"});
    ASSERT_EQ(plain.exitCode, 0) << plain.errors;
    const Image noisy = readExr(folder_ / "b.exr");
    ASSERT_EQ(picture.channels.size(), 3u);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(picture.channels[i].name, std::string("noisy.") + "BGR"[i]);
        std::vector<float> values;
        for (const glm::vec3& pixel : noisy.pixels)
            values.push_back(pixel[2 - static_cast<int>(i)]);
        EXPECT_EQ(std::get<std::vector<float>>(picture.channels[i].pixels), values);
    }
    EXPECT_NE(picture.color.pixels, noisy.pixels);
}

// The samples alone would need more of them.
TEST_F(DenoisedPictureTest, EndsByTheErrorAfterDenoising) {
    scene_ = std::string(kProjectFolder) + "/scenes/cornell-box.json";
    ASSERT_EQ(
        render({"-o", picture_, "--target-error", "0.16", "--stats", stats_, "--size", "64x64"})
            .exitCode,
        0);
    const auto json = statistics();
    EXPECT_EQ(json["ended_by"], "target-error");
    EXPECT_LE(json["denoised_bound"], 0.16);
    EXPECT_GT(json["error"]["relative"], 0.16);
    const ProgramResult result =
        render({"-o", picture_, "--target-error", "0.01", "--spp", "128", "--size", "48x48"});
    ASSERT_EQ(result.exitCode, 0);
    EXPECT_NE(result.errors.find("was not reached: after denoising it is"), std::string::npos)
        << result.errors;
}

TEST_F(DenoisedPictureTest, IsTheSameBytesAgain) {
    ASSERT_EQ(render({"-o", picture_, "--spp", "48"}).exitCode, 0);
    ASSERT_EQ(render({"-o", folder_ / "b.exr", "--spp", "48"}).exitCode, 0);
    EXPECT_TRUE(readText(picture_) == readText(folder_ / "b.exr"));
}

// The film holds 64 samples. The others must not change how those are denoised.
TEST_F(DenoisedPictureTest, IsThatOfTheFilmsWholeBlocks) {
    const std::string film = folder_ / "a.film";
    ASSERT_EQ(render({"-o", picture_, "--film", film, "--spp", "72"}).exitCode, 0);
    const std::string again = folder_ / "again.exr";
    ASSERT_EQ(runProgram({"denoise", film, "-o", again}).exitCode, 0);
    EXPECT_EQ(readExr(again).pixels, readExr(picture_).pixels);
}

TEST_F(DenoisedPictureTest, StatesNothingOfTooFewSamples) {
    for (const char* samples : {"5", "16", "64"}) {
        const ProgramResult result = render({"-o", picture_, "--spp", samples, "--stats", stats_});
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_TRUE(statistics()["denoised_error"].is_null()) << samples;
        EXPECT_NE(result.errors.find("denoised (error not stated: too few samples to tell"),
                  std::string::npos)
            << result.errors;
    }
}

TEST_F(DenoisedPictureTest, NeedsAFilmThatWasMadeForIt) {
    const std::string film = folder_ / "a.film";
    ASSERT_EQ(runProgram({"render", scene_, "--film", film, "--spp", "16"}).exitCode, 0);
    expectFailure(render({"--film", film, "--spp", "32"}), 3, "without --denoise");
    ASSERT_EQ(render({"--film", film, "--spp", "16", "--overwrite"}).exitCode, 0);
    // It can be continued with and without.
    ASSERT_EQ(runProgram({"render", scene_, "--film", film, "--spp", "32"}).exitCode, 0);
    EXPECT_EQ(render({"--film", film, "--spp", "48", "-o", picture_}).exitCode, 0);
}

} // namespace
} // namespace calotype::test
