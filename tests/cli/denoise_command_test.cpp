// calotype denoise, with a library that stands for the denoiser (tests/support/denoiser).
#include <algorithm>
#include <csignal>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "film/film_file.h"
#include "image/exr.h"
#include "support/image_files.h"
#include "support/paths.h"
#include "support/test_denoiser.h"

namespace calotype::test {
namespace {

/// Its error is stated for 128 samples per pixel.
const std::string kTrustedScene = std::string(kProjectFolder) + "/scenes/cornell-box.json";

class DenoiseCommandTest : public CliTest {
protected:
    ProgramResult run(const std::vector<std::string>& arguments) const {
        return runProgram(arguments, withFakeDenoiser());
    }

    /// `calotype denoise INPUT -o OUTPUT` and more.
    ProgramResult denoise(const std::string& input, const std::string& output,
                          const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"denoise", input, "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }

    /// Renders 64 x 48 pixels with these options, which must succeed.
    void render(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"render", scene_, "-q", "--size", "64x48"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = run(arguments);
        ASSERT_EQ(result.exitCode, 0) << result.errors;
    }

    nlohmann::json statistics() const { return nlohmann::json::parse(readText(stats_)); }

    std::string film_ = folder_ / "a.film";
    std::string picture_ = folder_ / "a.exr";
    std::string output_ = folder_ / "out.exr";
    std::string stats_ = folder_ / "stats.json";
};

const Channel* findChannel(const Picture& picture, const std::string& name) {
    const auto found = std::ranges::find(picture.channels, name, &Channel::name);
    return found == picture.channels.end() ? nullptr : &*found;
}

TEST_F(DenoiseCommandTest, AFilmGivesThePictureOfItsRender) {
    scene_ = kTrustedScene;
    render({"--spp", "128", "--denoise", "oidn", "--film", film_, "-o", picture_, "-o",
            folder_ / "a.png", "--exposure", "1"});
    const ProgramResult result =
        denoise(film_, output_, {"-o", folder_ / "out.png", "--exposure", "1", "--stats", stats_});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_TRUE(readText(output_) == readText(picture_));
    EXPECT_TRUE(readText(folder_ / "out.png") == readText(folder_ / "a.png"));
    EXPECT_NE(findChannel(readExrPicture(output_), "noisy.R"), nullptr);
    const auto json = statistics();
    EXPECT_EQ(json["denoiser"], "Open Image Denoise 2.0.0");
    EXPECT_EQ(json["denoiser_features"], "means");
    EXPECT_EQ(json["spp"], 128);
    EXPECT_EQ(json["resolution"], (nlohmann::json{64, 48}));
    EXPECT_GT(json["error"]["relative"], 0.0);
    EXPECT_GT(json["denoised_error"], 0.0);
    EXPECT_LT(json["denoised_error"], json["denoised_bound"]);
    EXPECT_TRUE(json["why_unstated"].is_null());
    EXPECT_NE(result.errors.find("denoised by Open Image Denoise 2.0.0"), std::string::npos);
    EXPECT_NE(result.errors.find(" %), "), result.errors.find("(at most ")) << result.errors;
}

TEST_F(DenoiseCommandTest, MergeDenoises) {
    render({"--spp", "128", "--denoise", "oidn", "--film", film_, "-o", picture_});
    ASSERT_EQ(run({"merge", film_, "--denoise", "off", "-o", output_}).exitCode, 0);
    EXPECT_EQ(readExrPicture(output_).channels.size(), 0u);
    const ProgramResult result = run({"merge", film_, "--denoise", "oidn", "-o", output_});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_TRUE(readText(output_) == readText(picture_));
    EXPECT_EQ(result.errors, "");
    EXPECT_NE(result.output.find("denoised  by Open Image Denoise 2.0.0, error "),
              std::string::npos)
        << result.output;
    const ProgramResult asJson =
        run({"merge", film_, "--denoise", "oidn", "-o", output_, "--json"});
    EXPECT_EQ(nlohmann::json::parse(asJson.output)["can_denoise"], true);
    EXPECT_NE(asJson.errors.find("denoised  by"), std::string::npos) << asJson.errors;
}

TEST_F(DenoiseCommandTest, MergeRefusesWhatCannotBeDenoised) {
    const std::string plain = folder_ / "plain.film";
    render({"--samples", "0:16", "--film", plain});
    render({"--samples", "16:32", "--denoise", "oidn", "--film", film_});
    expectFailure(run({"merge", plain, "--denoise", "oidn", "-o", output_}), 3,
                  "with --denoise from the start");
    expectFailure(run({"merge", film_, plain, "--denoise", "oidn", "-o", output_}), 3,
                  "with --denoise from the start");
    expectFailure(run({"merge", film_, "--denoise", "oidn", "-o", folder_ / "b.film"}), 2,
                  "add -o FILE.exr");
    expectFailure(run({"merge", film_, "--threads", "2", "-o", output_}), 2,
                  "--threads is for the denoiser");
    ProgramOptions nowhere;
    nowhere.environment["CALOTYPE_OIDN"] = "/nowhere";
    expectFailure(runProgram({"merge", film_, "--denoise", "oidn", "-o", output_}, nowhere), 2,
                  "--denoise needs Open Image Denoise 2");
    EXPECT_EQ(std::ranges::count(folder_.names(), "out.exr"), 0);
}

// Parts of a film, joined, are the film of one render, with what denoising needs.
TEST_F(DenoiseCommandTest, JoinedFilmsAreDenoisedAsOne) {
    render({"--spp", "32", "--denoise", "oidn", "--film", film_});
    const std::string a = folder_ / "1.film";
    const std::string b = folder_ / "2.film";
    render({"--samples", "16:32", "--denoise", "oidn", "--film", b});
    render({"--samples", "0:16", "--denoise", "oidn", "--film", a});
    const std::string both = folder_ / "both.film";
    ASSERT_EQ(run({"merge", b, a, "-o", both}).exitCode, 0);
    EXPECT_TRUE(readText(both) == readText(film_));
    // A film that goes on without --denoise keeps it, too.
    render({"--spp", "32", "--film", a});
    EXPECT_TRUE(readText(a) == readText(film_));
}

TEST_F(DenoiseCommandTest, AFilmWithoutFeaturesIsDenoisedWithAWarning) {
    render({"--spp", "16", "--denoise", "oidn", "--film", film_, "-o", picture_});
    const KeptFilm kept = readFilm(film_);
    ASSERT_TRUE(kept.features);
    writeFilm(film_, kept.label, kept.film);
    const ProgramResult result = denoise(film_, output_, {"--stats", stats_});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.errors.find("warning: " + film_ + " lacks the albedo and normals"),
              std::string::npos)
        << result.errors;
    EXPECT_TRUE(statistics()["denoiser_features"].is_null());
    EXPECT_NE(readExr(output_).pixels, readExr(picture_).pixels);
    // What the warning advises gives the picture with features.
    render({"--spp", "16", "--denoise", "oidn", "--film", film_, "-o", output_});
    EXPECT_TRUE(readText(output_) == readText(picture_));
}

TEST_F(DenoiseCommandTest, CompareSaysThatAPictureIsDenoised) {
    scene_ = kTrustedScene;
    const std::string png = folder_ / "a.png";
    render({"--spp", "128", "--denoise", "oidn", "-o", picture_, "-o", png, "--stats", stats_});
    const std::string plain = folder_ / "plain.png";
    render({"--spp", "4", "-o", plain});
    const auto stated = statistics()["denoised_error"].get<double>();
    for (const std::string& path : {picture_, png}) {
        const std::vector<std::string> arguments = {"compare", path, plain};
        const std::string text = run(arguments).output;
        const std::string first = text.substr(0, text.find('\n'));
        EXPECT_NE(first.find(", denoised by Open Image Denoise 2.0.0 (error "), std::string::npos)
            << text;
        EXPECT_EQ(text.find("denoised", first.size()), std::string::npos) << text;
        const auto json = nlohmann::json::parse(run({"compare", plain, path, "--json"}).output);
        EXPECT_EQ(json["b"]["denoiser"], "Open Image Denoise 2.0.0");
        EXPECT_NEAR(json["b"]["denoised_error"].get<double>(), stated, 1e-5 * stated);
        EXPECT_GT(json["b"]["denoised_bound"], json["b"]["denoised_error"]);
        EXPECT_TRUE(json["a"]["denoiser"].is_null());
    }
    EXPECT_EQ(readText(plain).find("tEXt"), std::string::npos);
}

TEST_F(DenoiseCommandTest, SaysWhyAFilmHasNoStatedError) {
    render({"--spp", "64", "--denoise", "oidn", "--film", film_});
    const ProgramResult result = denoise(film_, output_, {"--stats", stats_});
    EXPECT_NE(result.errors.find("error not stated: too few samples to tell"), std::string::npos)
        << result.errors;
    EXPECT_TRUE(statistics()["denoised_error"].is_null());
    EXPECT_EQ(statistics()["why_unstated"], "too few samples to tell");
}

TEST_F(DenoiseCommandTest, APictureKeepsItsLayersAndMetadata) {
    render({"--spp", "8", "--crop", "8,4,40,32", "-o", picture_, "--aov",
            "meanAlbedo,meanNormal,depth,primitive"});
    const ProgramResult result = denoise(picture_, output_, {"--stats", stats_});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_NE(result.errors.find("error not stated: an EXR file"), std::string::npos);
    EXPECT_EQ(statistics()["spp"], 8);
    EXPECT_EQ(statistics()["denoiser_features"], "means");
    const Picture before = readExrPicture(picture_);
    const Picture after = readExrPicture(output_);
    EXPECT_NE(after.color.pixels, before.color.pixels);
    for (const Channel& channel : before.channels) {
        ASSERT_NE(findChannel(after, channel.name), nullptr) << channel.name;
        EXPECT_EQ(findChannel(after, channel.name)->pixels, channel.pixels) << channel.name;
    }
    EXPECT_EQ(after.channels.size(), before.channels.size() + 3);
    for (int i = 0; i < 3; ++i) {
        std::vector<float> values;
        for (const glm::vec3& pixel : before.color.pixels)
            values.push_back(pixel[i]);
        EXPECT_EQ(std::get<0>(findChannel(after, std::string("noisy.") + "RGB"[i])->pixels),
                  values);
    }
    ASSERT_EQ(after.metadata.size(), before.metadata.size() + 1);
    for (const Attribute& attribute : before.metadata) {
        const auto same = std::ranges::find(after.metadata, attribute.name, &Attribute::name);
        ASSERT_NE(same, after.metadata.end()) << attribute.name;
        EXPECT_EQ(same->value, attribute.value);
    }
    ASSERT_TRUE(after.crop);
    EXPECT_EQ(after.crop->x, 8u);
    EXPECT_EQ(after.crop->y, 4u);
    EXPECT_EQ(after.crop->filmWidth, 64u);
    EXPECT_EQ(after.crop->filmHeight, 48u);
}

// What is denoised a second time is the samples, not the denoised picture.
TEST_F(DenoiseCommandTest, ADenoisedPictureIsDenoisedFromItsSamples) {
    render({"--spp", "8", "-o", picture_, "--aov", "meanAlbedo,meanNormal"});
    ASSERT_EQ(denoise(picture_, output_).exitCode, 0);
    const std::string again = folder_ / "again.exr";
    ASSERT_EQ(denoise(output_, again).exitCode, 0);
    EXPECT_TRUE(readText(again) == readText(output_));
    Picture picture = readExrPicture(output_);
    picture.channels.clear();
    writeExr(output_, picture);
    expectFailure(denoise(output_, folder_ / "no.exr"), 3, "denoised already");
}

TEST_F(DenoiseCommandTest, UsesTheFeaturesThatAPictureHas) {
    const auto denoised = [&](const std::string& layers, const std::string& warning) {
        render({"--spp", "8", "-o", picture_, "--aov", layers});
        const ProgramResult result = denoise(picture_, output_, {"--stats", stats_});
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_EQ(result.errors.find("warning") != std::string::npos, !warning.empty());
        EXPECT_NE(result.errors.find(warning), std::string::npos) << result.errors;
        return readExr(output_).pixels;
    };
    const auto means = denoised("meanAlbedo,meanNormal,albedo,normal", "");
    const auto hits = denoised("albedo,normal,meanAlbedo", "do not show what is in mirrors");
    EXPECT_EQ(statistics()["denoiser_features"], "first hits");
    const auto none = denoised("albedo,depth", "edges and textures may be lost");
    EXPECT_TRUE(statistics()["denoiser_features"].is_null());
    EXPECT_NE(means, hits);
    EXPECT_NE(hits, none);
    EXPECT_NE(means, none);
}

TEST_F(DenoiseCommandTest, RefusesWhatCannotBeDenoised) {
    render({"--spp", "16", "--film", film_, "-o", picture_, "-o", folder_ / "a.png"});
    expectFailure(denoise(film_, output_), 3, "rendered without --denoise");
    expectFailure(denoise(folder_ / "a.png", output_), 3, "films and EXR files can be denoised");
    expectFailure(denoise(scene_, output_), 3, "films and EXR files can be denoised");
    expectFailure(denoise(folder_ / "none.exr", output_), 3, "check that it exists");
    expectFailure(denoise(picture_, picture_), 2, "is read by this command");
    expectFailure(denoise(picture_, folder_ / "out.film"), 2, "no known extension");
    expectFailure(run({"denoise", picture_}), 2, "--output");
    Picture picture = readExrPicture(picture_);
    writeExr(folder_ / "b.exr", picture);
    picture.color.at(3, 2).g = std::numeric_limits<float>::infinity();
    writeExr(picture_, picture);
    expectFailure(denoise(picture_, output_), 3, "1 pixels are not finite, the first at (3, 2)");
    const std::string other =
        folder_.write("other.exr", withOtherPrimaries(readText(folder_ / "b.exr")));
    expectFailure(denoise(other, output_), 3, "has other primaries");
    ProgramOptions nowhere;
    nowhere.environment["CALOTYPE_OIDN"] = "/nowhere";
    expectFailure(runProgram({"denoise", film_, "-o", output_}, nowhere), 2,
                  "calotype denoise needs Open Image Denoise 2");
    EXPECT_EQ(std::ranges::count(folder_.names(), "out.exr"), 0);
}

TEST_F(DenoiseCommandTest, AnEmptyFilmIsRefused) {
    render({"--spp", "16", "--denoise", "oidn", "--film", film_});
    const KeptFilm kept = readFilm(film_);
    writeFilm(film_, kept.label,
              Film(kept.film.width(), kept.film.height(), kept.film.unit(), ReplicaDetail::Color),
              kept.features);
    expectFailure(denoise(film_, output_), 3, "has no samples");
}

TEST_F(DenoiseCommandTest, AFailingDenoiserWritesNothing) {
    render({"--spp", "16", "--denoise", "oidn", "--film", film_});
    expectFailure(runProgram({"denoise", film_, "-o", output_}, withFakeDenoiser("fails")), 1,
                  "Open Image Denoise failed: it was told to");
    EXPECT_EQ(std::ranges::count(folder_.names(), "out.exr"), 0);
}

// Eight replicas and a picture take 2.7 s.
TEST_F(DenoiseCommandTest, AnInterruptEndsIt) {
    render({"--spp", "128", "--denoise", "oidn", "--film", film_});
    ProgramOptions options = withFakeDenoiser("slow");
    bool isSent = false;
    options.whileRunning = [&](int pid, double age) {
        if (!isSent && age > 0.7)
            isSent = kill(pid, SIGINT) == 0;
    };
    const ProgramResult result = runProgram({"denoise", film_, "-o", output_}, options);
    expectFailure(result, 1, "interrupted; nothing was written");
    EXPECT_LT(result.seconds, 2.5);
    EXPECT_EQ(std::ranges::count(folder_.names(), "out.exr"), 0);
}

} // namespace
} // namespace calotype::test
