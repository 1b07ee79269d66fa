// `calotype info` and `calotype devices`.
#include <algorithm>

#include "cli/cli_test.h"

namespace calotype::test {
namespace {

using InfoTest = CliTest;

TEST_F(InfoTest, InfoShowsCountsMemoryAndFeatures) {
    const ProgramResult result = runProgram({"info", scene_});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    for (const char* text : {"2 triangles, 2 quadrics", "lights      1", "bounds      (-3, 0, -3)",
                             "BVH", "MiB", "triangles, spheres, disks, disk lights"})
        EXPECT_NE(result.output.find(text), std::string::npos) << text << "\n" << result.output;
}

TEST_F(InfoTest, InfoAppliesOverrides) {
    const ProgramResult result = runProgram({"info", scene_, "--set", "/shapes/1/type=cube"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.errors.find("/shapes/1"), std::string::npos) << result.errors;
}

TEST_F(InfoTest, DevicesSayWhichIsTakenAndWhy) {
    const ProgramResult result = runProgram({"devices"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output.rfind("0  ", 0), 0u) << result.output;
    EXPECT_NE(result.output.find("would take "), std::string::npos);
    const ProgramResult byIndex = runProgram({"devices", "--device", "0"});
    EXPECT_NE(byIndex.output.find("matches --device '0'"), std::string::npos) << byIndex.output;
    ProgramOptions wish;
    wish.environment["CALOTYPE_DEVICE"] = "0";
    EXPECT_NE(runProgram({"devices"}, wish).output.find("CALOTYPE_DEVICE"), std::string::npos);
}

} // namespace
} // namespace calotype::test
