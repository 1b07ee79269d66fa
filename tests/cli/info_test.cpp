// `calotype info` and `calotype devices`.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "support/image_files.h"

namespace calotype::test {
namespace {

using InfoTest = CliTest;
using Json = nlohmann::json;

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

TEST_F(InfoTest, PrintsJson) {
    const Json info = Json::parse(runProgram({"info", scene_, "--json"}).output);
    EXPECT_EQ(info["format"], 1);
    EXPECT_EQ(info["version"], CALOTYPE_VERSION);
    EXPECT_EQ(info["triangles"], 2);
    EXPECT_EQ(info["quadrics"], 2);
    EXPECT_EQ(info["bounds"]["lower"], Json({-3, 0, -3}));
    EXPECT_GT(info["memory_bytes"]["picture"], 0);
    const Json devices = Json::parse(runProgram({"devices", "--json"}).output);
    EXPECT_EQ(devices["format"], 1);
    const Json& first = devices["devices"][0];
    EXPECT_EQ(first["index"], 0);
    EXPECT_EQ(first["uuid"].get<std::string>().size(), 36u);
    const std::string chosen = devices["devices"][devices["chosen"].get<size_t>()]["uuid"];
    const ProgramResult byUuid = runProgram({"devices", "--device", chosen});
    EXPECT_NE(byUuid.output.find("matches --device '" + chosen), std::string::npos);
}

// A scene may come through a pipe; its files are then relative to the working folder.
TEST_F(InfoTest, ReadsASceneFromStandardInput) {
    ProgramOptions options;
    options.input = R"({ "camera": {}, "materials": { "m": { "type": "diffuse", "color": 1 } },
        "shapes": [{ "type": "sphere", "radius": 1, "material": "m" }] })";
    const ProgramResult result = runProgram({"info", "-"}, options);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("shapes      1"), std::string::npos) << result.output;
    options.input = "{ \"camera\": {}, }";
    expectFailure(runProgram({"info", "-"}, options), 3, "standard input:1:15: there is a comma");
    options.input = "";
    expectFailure(runProgram({"info", "-"}, options), 3, "standard input:1:1: the file is empty");
}

} // namespace
} // namespace calotype::test
