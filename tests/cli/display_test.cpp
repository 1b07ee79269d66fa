// How pictures are brought to a display: --exposure and --tonemap.
#include <string>

#include <gtest/gtest.h>

#include "cli/cli_test.h"
#include "film/write_picture.h"
#include "image/exr.h"

namespace calotype::test {
namespace {

class DisplayTest : public CliTest {};

// The PNG is the display transform of the linear picture, which the options leave alone.
TEST_F(DisplayTest, ExposureAndToneMapGoIntoThePngOnly) {
    const std::string png = folder_ / "a.png";
    const std::string exr = folder_ / "a.exr";
    const std::string plainExr = folder_ / "plain.exr";
    EXPECT_EQ(runProgram({"render", scene_, "-o", png, "-o", exr, "--exposure", "2", "--tonemap",
                          "neutral"})
                  .exitCode,
              0);
    EXPECT_EQ(runProgram({"render", scene_, "-o", plainExr}).exitCode, 0);
    EXPECT_EQ(readExr(plainExr).pixels, readExr(exr).pixels);
    const std::string expected = folder_ / "expected.png";
    writePicture(expected, {readExr(exr)}, {.exposureStops = 2.0f, .toneMap = ToneMap::Neutral});
    EXPECT_EQ(readText(png), readText(expected));
    writePicture(expected, {readExr(exr)}, {});
    EXPECT_NE(readText(png), readText(expected));
}

TEST_F(DisplayTest, ChoosesTheExposureAndPrintsIt) {
    const std::string png = folder_ / "a.png";
    const std::string exr = folder_ / "a.exr";
    const ProgramResult result =
        runProgram({"render", scene_, "-o", png, "-o", exr, "--exposure", "auto"});
    EXPECT_EQ(result.exitCode, 0);
    const std::string line = "; --exposure ";
    const size_t place = result.errors.find(line);
    ASSERT_NE(place, std::string::npos) << result.errors;
    const float stops = std::stof(result.errors.substr(place + line.size()));
    EXPECT_EQ(stops, exposureOf(readExr(exr)));
    EXPECT_NE(stops, 0.0f);
    const std::string expected = folder_ / "expected.png";
    writePicture(expected, {readExr(exr)}, {.exposureStops = stops});
    EXPECT_EQ(readText(png), readText(expected));
}

} // namespace
} // namespace calotype::test
