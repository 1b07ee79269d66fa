// `calotype info` and `calotype devices`.
#include <algorithm>

#include "cli/cli_test.h"
#include "support/image_files.h"

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

// Forty images of 4 GiB each, of which only the headers exist: too many for a device or this
// machine.
TEST_F(InfoTest, TexturesThatDoNotFitAreRefusedByTheirHeaders) {
    std::string textures;
    std::string materials;
    for (int i = 0; i < 40; ++i) {
        const std::string name = std::to_string(i);
        folder_.write(name + ".png", pngFile(16384, 16384, 16, 6, ""));
        textures +=
            (i > 0 ? ", \"" : "\"") + name + R"(": {"type": "image", "file": ")" + name + ".png\"}";
        materials += ", \"" + name + R"(": {"type": "diffuse", "color": ")" + name + "\"}";
    }
    std::string scene = kSmallScene;
    scene.insert(scene.find("\"materials\""), "\"textures\": {" + textures + "}, ");
    scene.insert(scene.find(" },\n  \"shapes\""), materials);
    const std::string path = folder_.write("large.json", scene);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"info", path},
          {"render", path, "-o", folder_ / "a.png", "--quiet"},
          {"render", path, "-o", folder_ / "a.png", "--quiet", "--device", "reference"}}) {
        const ProgramResult result = runProgram(command);
        expectFailure(result, command.back() == "reference" ? 1 : 4, "take 163840 MiB");
        EXPECT_NE(
            result.errors.find("the largest of 40 files are \"0.png\" (16384 x 16384, 4096 MiB)"),
            std::string::npos)
            << result.errors;
    }
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
