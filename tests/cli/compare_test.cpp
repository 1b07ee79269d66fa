// What `calotype compare` prints, draws and returns.
#include <cmath>
#include <filesystem>
#include <limits>

#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "image/exr.h"
#include "image/pfm.h"
#include "image/read_texel_image.h"
#include "support/image_files.h"
#include "support/paths.h"

namespace calotype::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class CompareTest : public testing::Test {
protected:
    std::string write(const std::string& name, uint32_t width, std::vector<glm::vec3> pixels) {
        Image image(width, static_cast<uint32_t>(pixels.size()) / width);
        image.pixels = std::move(pixels);
        const std::string path = folder_ / name;
        if (name.ends_with(".pfm"))
            writePfm(path, image);
        else
            writeExr(path, {image});
        return path;
    }

    TestFolder folder_;
    std::string a_ = write("a.exr", 2, {{1, 2, 3}, {0, 0, 0}, {0.5f, 0, 8}, {1, 1, 1}});
    std::string b_ = write("b.pfm", 2, {{1, 1, 3}, {0, 0, 0}, {0, 0.25f, 10}, {1, 1, 1}});
};

// The figures by hand are in tests/unit/image_difference_test.cpp.
TEST_F(CompareTest, PrintsEveryFigure) {
    const ProgramResult result = runProgram({"compare", a_, b_});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(result.output,
              "A             " + a_ + ", 2 x 2 pixels, 0 infinite\n" + "B             " + b_ +
                  ", 2 x 2 pixels, 0 infinite\n" +
                  "mean error    -0.0625 (R 0.125, G 0.1875, B -0.5), of A - B\n"
                  "RMSE          0.665363\n"
                  "relative MSE  2.24101, the mean of (A - B)^2 / (B^2 + 0.01)\n"
                  "PSNR          23.5388 dB, for a peak of 10, the largest value of B\n"
                  "largest       2 in B at (0, 1) from the top left: A (0.5, 0, 8), "
                  "B (0, 0.25, 10)\n");
}

TEST_F(CompareTest, PrintsJson) {
    const auto json = nlohmann::json::parse(runProgram({"compare", a_, b_, "--json"}).output);
    EXPECT_EQ(json["format"], 1);
    EXPECT_EQ(json["a"]["file"], a_);
    EXPECT_EQ(json["mean_error"], nlohmann::json({0.125, 0.1875, -0.5}));
    EXPECT_NEAR(json["rmse"].get<double>(), 0.665363, 1e-6);
    EXPECT_EQ(json["largest"]["difference"], 2.0);
    EXPECT_EQ(json["largest"]["y"], 1);
    EXPECT_EQ(json["largest"]["channel"], 2);
    const ProgramResult equal = runProgram({"compare", a_, a_, "--json", "--max-relmse", "0"});
    EXPECT_EQ(equal.exitCode, 0);
    EXPECT_TRUE(nlohmann::json::parse(equal.output)["psnr"].is_null());
}

// A file's name may hold any bytes; JSON is UTF-8.
TEST_F(CompareTest, JsonIsValidWhateverTheNames) {
    const std::string path = folder_ / "b\xff.pfm";
    std::filesystem::copy(b_, path);
    const ProgramResult result = runProgram({"compare", a_, path, "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_TRUE(nlohmann::json::accept(result.output)) << result.output;
}

TEST_F(CompareTest, OfEqualPicturesIsInfinitelyNear) {
    const std::string diff = folder_ / "diff.png";
    const ProgramResult result =
        runProgram({"compare", a_, a_, "--max-relmse", "0", "--diff", diff});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    for (const char* line : {"\nmean error    0 (R 0, G 0, B 0), of A - B\n", "\nRMSE          0\n",
                             "\nrelative MSE  0, ", "\nPSNR          inf dB, for a peak of 8, ",
                             "\nlargest       0\n"})
        EXPECT_NE(result.output.find(line), std::string::npos) << line << result.output;
    const TexelImage picture = readTexelImage(readText(diff), 2, "diff");
    for (size_t i = 0; i < picture.bytes.size(); ++i)
        EXPECT_EQ(picture.bytes[i], i % 4 == 3 ? 255 : 0);
}

TEST_F(CompareTest, ReadsPngsAndHdrPicturesAsLinearLight) {
    const std::string png = folder_.write("a.png", pngOf({188, 188, 188, 0}, 1));
    const std::string hdr =
        folder_.write("a.hdr", "#?RADIANCE\n\n-Y 1 +X 1\n\x80\x80\x80\x80"); // 0.5
    const ProgramResult result = runProgram({"compare", png, hdr});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("mean error    0.002886"), std::string::npos) << result.output;
}

TEST_F(CompareTest, ExitsByTheThreshold) {
    EXPECT_EQ(runProgram({"compare", a_, b_, "--max-relmse", "2.2411"}).exitCode, 0);
    const ProgramResult result = runProgram({"compare", a_, b_, "--max-relmse", "2.2410"});
    expectFailure(result, 5, "relative MSE of 2.24101");
    EXPECT_NE(result.output.find("\nrelative MSE  2.24101"), std::string::npos) << result.output;
    const std::string diff = folder_ / "diff.png";
    expectFailure(runProgram({"compare", a_, b_, "--max-relmse", "0", "--diff", diff}), 5,
                  "--max-relmse 0");
    EXPECT_TRUE(std::filesystem::exists(diff)); // most wanted where the pictures differ
}

// (1 - 0.875)^2 / (0.875^2 + 0.01) in each channel of one of the two pixels that count.
TEST_F(CompareTest, LeavesOutInfinitePixels) {
    const std::string c =
        write("c.exr", 2, {{1, 1, 1}, {kInfinity, 0, 0}, {0, 0, 0}, {0, -kInfinity, 0}});
    const std::string d = write(
        "d.exr", 2, {{0.875f, 0.875f, 0.875f}, {kInfinity, 9, 9}, {0, 0, 0}, {0, -kInfinity, 0}});
    const ProgramResult same = runProgram({"compare", c, d, "--max-relmse", "0.0101"});
    EXPECT_EQ(same.exitCode, 0) << same.errors;
    for (const std::string& text :
         {c + ", 2 x 2 pixels, 2 infinite\n", d + ", 2 x 2 pixels, 2 infinite\n",
          std::string("\nlargest       0.125 in R at (0, 0)"),
          std::string("\nrelative MSE  0.0100725"),
          std::string("\nleft out      2 of 4 pixels, infinite in A or B\n")})
        EXPECT_NE(same.output.find(text), std::string::npos) << text << "\n" << same.output;

    const std::string e = write("e.exr", 2, {{1, 1, 1}, {kInfinity, 0, 0}, {0, 0, 0}, {}});
    EXPECT_EQ(runProgram({"compare", c, e}).exitCode, 0);
    expectFailure(runProgram({"compare", c, e, "--max-relmse", "1e-3"}), 5,
                  "infinite in A or B only (1) exceed any --max-relmse");
}

TEST_F(CompareTest, DrawsKnownDifferencesInFalseColour) {
    // From black, relatively ten times as large: nothing, 1e-4, 1e-2, above 1; infinite.
    const std::string light = write("light.exr", 5,
                                    {glm::vec3(0.0f), glm::vec3(1.0001e-5f), glm::vec3(1e-3f),
                                     glm::vec3(7.0f), glm::vec3(kInfinity)});
    const std::string black = write("black.exr", 5, std::vector<glm::vec3>(5));
    const std::string diff = folder_ / "diff.PNG";
    EXPECT_EQ(runProgram({"compare", light, black, "--diff", diff}).exitCode, 0);
    const TexelImage picture = readTexelImage(readText(diff), 5, "diff");
    EXPECT_EQ(picture.bytes,
              (std::vector<uint8_t>{0,   0,   0,   255, 2,  5,   110, 255, 196, 68,
                                    108, 255, 239, 227, 77, 255, 0,   255, 255, 255}));
}

TEST_F(CompareTest, RefusesPicturesThatCannotBeCompared) {
    const std::string wide = write("wide.exr", 4, std::vector<glm::vec3>(4));
    expectFailure(runProgram({"compare", a_, wide}), 3,
                  a_ + ": the picture has 2 x 2 pixels and '" + wide + "' has 4 x 1");
    const std::string nan = write("nan.exr", 2, {{}, {0, NAN, 0}, {}, {NAN, NAN, NAN}});
    const std::string message = nan + ": 2 of 4 pixels are NaN, the first at (1, 0)";
    expectFailure(runProgram({"compare", nan, b_}), 3, message);
    expectFailure(runProgram({"compare", b_, nan, "--max-relmse", "9"}), 3, message);
    const std::string infinite = write("inf.exr", 2, std::vector<glm::vec3>(4, {0, kInfinity, 0}));
    expectFailure(runProgram({"compare", infinite, b_}), 3, "no pixel is finite");
}

TEST_F(CompareTest, WarnsOfOtherPrimaries) {
    const std::string other = folder_.write("other.exr", withOtherPrimaries(readText(a_)));
    const ProgramResult result = runProgram({"compare", other, a_, "--max-relmse", "0"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.errors.find("warning: " + other + " has other primaries"), std::string::npos)
        << result.errors;
    EXPECT_EQ(result.errors.find(a_ + " has other"), std::string::npos) << result.errors;
}

TEST_F(CompareTest, RefusesFilesThatAreNoPictures) {
    const std::string text = folder_.write("text.exr", "no picture");
    const std::string cut = folder_.write("cut.exr", readText(a_).substr(0, 300));
    const std::string empty = folder_.write("empty.png", "");
    const std::string cutPng = folder_.write("cut.png", pngOf({1, 2, 3, 4}).substr(0, 50));
    const std::pair<std::string, std::string> cases[] = {
        {folder_ / "missing.exr", "missing.exr"},
        {folder_.path().string(), "not a regular file"},
        {text, "EXR, PFM (colour), HDR and PNG can be compared"},
        {cut, "EXR file cannot be read"},
        {empty, "EXR, PFM (colour), HDR and PNG can be compared"},
        {cutPng, "incomplete"},
    };
    const std::string diff = folder_ / "diff.png";
    for (const auto& [path, fragment] : cases) {
        SCOPED_TRACE(path);
        expectFailure(runProgram({"compare", path, b_, "--diff", diff}), 3, fragment);
        expectFailure(runProgram({"compare", a_, path, "--diff", diff}), 3, fragment);
    }
    EXPECT_FALSE(std::filesystem::exists(diff));
}

TEST_F(CompareTest, RefusesWrongUsage) {
    const std::string png = folder_.write("in.png", pngOf({1, 2, 3, 4}));
    const std::string before = readText(png);
    std::filesystem::create_symlink(png, folder_ / "link.png");
    const std::pair<std::vector<std::string>, std::string> cases[] = {
        {{"compare"}, "required"},
        {{"compare", a_}, "required"},
        {{"compare", a_, b_, b_}, "b.pfm"},
        {{"compare", a_, b_, "--max-relmse", "-1"}, "at least 0"},
        {{"compare", a_, b_, "--max-relmse", "nan"}, "at least 0"},
        {{"compare", a_, b_, "--max-relmse", "inf"}, "at least 0"},
        {{"compare", a_, b_, "--max-relmse", "1", "--max-relmse", "2"}, "--max-relmse"},
        {{"compare", a_, b_, "--diff", folder_ / "diff.exr"}, "name it .png"},
        {{"compare", a_, b_, "--diff", folder_ / "diff"}, "name it .png"},
        {{"compare", png, b_, "--diff", png}, "is read by this command"},
        {{"compare", b_, png, "--diff", folder_ / "./in.png"}, "is read by this command"},
        {{"compare", b_, png, "--diff", folder_ / "link.png"}, "is read by this command"},
    };
    for (const auto& [arguments, fragment] : cases) {
        SCOPED_TRACE(fragment);
        expectFailure(runProgram(arguments), 2, fragment);
    }
    EXPECT_EQ(readText(png), before);
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.exr", "b.pfm", "in.png", "link.png"}));
}

// Said before anything is read, so that the missing picture is not met.
TEST_F(CompareTest, RefusesAnUnwritableDifferencePicture) {
    expectFailure(
        runProgram({"compare", a_, folder_ / "missing.exr", "--diff", folder_ / "no/diff.png"}), 6,
        "diff.png");
}

TEST_F(CompareTest, HelpExplainsTheColoursAndTheExitCode) {
    const std::string help = runProgram({"compare", "--help"}).output;
    for (const char* text : {"--diff", "--max-relmse", "black below 1e-4", "cyan", "Exit with 5"})
        EXPECT_NE(help.find(text), std::string::npos) << text << help;
    EXPECT_NE(runProgram({"--help"}).output.find("5 pictures differ"), std::string::npos);
}

// A public picture in both forms, where the display's form cuts off what is brighter than white.
TEST_F(CompareTest, ReadsPicturesOfOtherPrograms) {
    const std::string stem =
        kProjectFolder + std::string("/../shared/data/bitterli-cornell-box/TungstenRender");
    if (!std::filesystem::exists(stem + ".exr"))
        GTEST_SKIP() << "../shared/data is not there";
    const ProgramResult result = runProgram({"compare", stem + ".png", stem + ".exr"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("B (17, 12, 4)"), std::string::npos) << result.output;
}

} // namespace
} // namespace calotype::test
