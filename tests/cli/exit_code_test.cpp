// Every kind of mistake has its exit code and one sentence, and nothing is written.
#include <algorithm>

#include "cli/cli_test.h"

namespace calotype::test {
namespace {

using ExitCodeTest = CliTest;

TEST_F(ExitCodeTest, HelpAndVersion) {
    const ProgramResult help = runProgram({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_NE(help.output.find("render"), std::string::npos);
    EXPECT_NE(runProgram({"render", "--help"}).output.find("--preview-every"), std::string::npos);
    EXPECT_EQ(runProgram({"help"}).output, help.output);
    EXPECT_EQ(runProgram({"help", "render"}).output, runProgram({"render", "--help"}).output);
    const std::string version = runProgram({"--version"}).output;
    EXPECT_TRUE(version.starts_with("calotype " CALOTYPE_VERSION)) << version;
    EXPECT_EQ(std::ranges::count(version, '\n'), 1) << version;
}

TEST_F(ExitCodeTest, WrongUsage) {
    const std::string out = folder_ / "out.png";
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{}, "a command is required, such as: calotype render"},
        {{"paint"}, "there is no command \"paint\""},
        {{"rendr", "q.json"}, "no command \"rendr\"; did you mean \"render\"?"},
        {{"help", "rendr"}, "did you mean \"render\"?"},
        {{"render"}, "scene is required (see calotype render --help)"},
        {{"render", scene_}, "-o"},
        {{"render", scene_, "-o", out, "--ssp", "4"}, "\"--ssp\"; did you mean --spp?"},
        {{"render", scene_, "-o", out, "--frames", "1:24"}, "animations cannot be rendered yet"},
        {{"render", scene_, "-o", out, "--spp", "4", "--spp", "8"}, "--spp"},
        {{"render", scene_, "-o", out, "--quiet", "--quiet"}, "--quiet"},
        {{"render", scene_, "-o", out, "--size", "4x4", "--size", "8x8"}, "--size"},
        {{"render", scene_, "-o", out, "--spp", "0"}, "--spp"},
        {{"render", scene_, "-o", out, "--spp", "-1"}, "--spp"},
        {{"render", scene_, "-o", out, "--spp", "many"}, "--spp"},
        {{"render", scene_, "-o", out, "--seed", "-1"},
         "--seed '-1' is not a whole number from 0 to 4294967295"},
        {{"render", scene_, "-o", out, "--size", "64"}, "WIDTHxHEIGHT"},
        {{"render", scene_, "-o", out, "--size", "0x4"}, "WIDTHxHEIGHT"},
        {{"render", scene_, "-o", out, "--size", "64x65536"}, "65535"},
        {{"render", scene_, "-o", out, "--crop", "0,0,4"}, "--crop"},
        {{"render", scene_, "-o", out, "--crop", "30,0,4,4"}, "--crop"},
        {{"render", scene_, "-o", out, "--crop", "4294967295,0,4,4"}, "--crop"},
        {{"render", scene_, "-o", out, "--exposure", "nan"}, "--exposure"},
        {{"render", scene_, "-o", out, "--tonemap", "rosy"}, "neutral"},
        {{"render", scene_, "-o", out, "--sampler", "halton"}, "sobol"},
        {{"render", scene_, "-o", out, "--mis", "maybe"}, "--mis 'maybe' is not on or off"},
        {{"render", scene_, "-o", out, "--roulette", ""}, "--roulette"},
        {{"render", scene_, "-o", out, "--clamp-indirect", "0"}, "--clamp-indirect"},
        {{"render", scene_, "-o", out, "--clamp-indirect", "nan"}, "--clamp-indirect"},
        {{"render", scene_, "-o", out, "--light-choice", "best"}, "uniform or all"},
        {{"render", scene_, "-o", out, "--light-choice", "all"}, "--device reference"},
        {{"render", scene_, "-o", out, "--texture-filter", "cubic"}, "bilinear or nearest"},
        {{"render", scene_, "-o", out, "--missing-textures", "ignore"}, "fail or warn"},
        {{"render", scene_, "-o", out, "--preview-every", "0"}, "--preview-every"},
        {{"render", scene_, "-o", out, "--preview-every", "-3s"}, "--preview-every"},
        {{"render", scene_, "-o", out, "--threads", "0"}, "--threads"},
        {{"render", scene_, "-o", out, "--set", "render/spp=4"}, "--set"},
        {{"render", scene_, "-o", out, "--set", "/render/spp"}, "--set"},
        {{"render", scene_, "-o", folder_ / "out.gif"}, ".png"},
        {{"render", scene_, "-o", folder_ / "out"}, ".png"},
        {{"render", scene_, "-o", folder_.path()}, "is a folder; name a file in it"},
        {{"render", scene_, "-o", out, "--film", folder_.path()}, "is a folder"},
        {{"render", scene_, "-o", out, "--stats", folder_.path()}, "is a folder"},
        {{"render", scene_, "-o", "-.exr"}, "standard output; name a file in place of '-.exr'"},
        {{"render", scene_, "-o", "-"}, "standard output"},
        {{"render", scene_, "-o", folder_ / "frame.%04d.png"}, "animations cannot be rendered yet"},
        {{"render", scene_, "-o", folder_ / "frame.####.exr"}, "animations cannot be rendered yet"},
        {{"render", scene_, "-o", folder_ / "5%_frame%d.png"}, "animations cannot be rendered yet"},
        {{"render", scene_, "-o", folder_ / "frame.$F4.png"}, "animations cannot be rendered yet"},
        {{"render", scene_, "-o", folder_ / "my%20dog.gif"}, "has no known extension"},
        {{"render", scene_, "-o", out, "--progress", "xml"}, "text or json"},
        {{"render", scene_, "-o", out, "--from", "1,2"}, "X,Y,Z in metres"},
        {{"render", scene_, "-o", out, "--up", "0,0,0"}, "'0,0,0' is not a direction"},
        {{"render", scene_, "-o", out, "--preview-file", "x.png"}, "add --preview-every"},
        {{"render", scene_, "-o", out, "--look-at", "1,2,nan"}, "X,Y,Z in metres"},
        {{"render", scene_, "-o", out, "--fov", "180"}, "between 0 and 180"},
        {{"render", scene_, "-o", out, "--overwrite"}, "--film"},
        {{"render", scene_, "-o", out, "-o", out}, "twice"},
        {{"render", scene_, "-o", out, "--preview-every", "2", "--preview-file", "x.bmp"}, ".png"},
        {{"render", scene_, "-o", out, "-o", folder_ / "./out.png"}, "twice"},
        {{"render", scene_, "-o", out, "--stats", scene_}, "is read by this command"},
        {{"render", scene_, "-o", out, "--stats", out}, "twice"},
        {{"render", scene_, scene_, "-o", out}, "takes no further argument"},
        {{"info"}, "required"},
    };
    for (const auto& [arguments, fragment] : cases) {
        SCOPED_TRACE(fragment);
        expectFailure(runProgram(arguments), 2, fragment);
    }
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
}

TEST_F(ExitCodeTest, BadScene) {
    const std::string out = folder_ / "out.png";
    const auto render = [&](const std::string& scene) {
        return runProgram({"render", scene, "-o", out});
    };
    expectFailure(render(folder_ / "missing.json"), 3, "missing.json");
    expectFailure(render(folder_.path().string()), 3, folder_.path().filename());
    expectFailure(render(folder_.write("empty.json", "")), 3, "empty.json");
    expectFailure(render(folder_.write("syntax.json", "{\n  \"camera\": {,}\n}")), 3,
                  "syntax.json:2");
    expectFailure(render(folder_.write("key.json", R"({ "camrea": {} })")), 3, "camera");
    expectFailure(runProgram({"render", scene_, "-o", out, "--set", "/materials/grey/color=2"}), 3,
                  "/materials/grey/color");
    expectFailure(runProgram({"info", folder_ / "missing.json"}), 3, "missing.json");
    EXPECT_EQ(std::ranges::count(folder_.names(), "out.png"), 0);
}

TEST_F(ExitCodeTest, Device) {
    const std::string out = folder_ / "out.png";
    expectFailure(runProgram({"render", scene_, "-o", out, "--device", "voodoo"}), 4, "voodoo");
    expectFailure(runProgram({"render", scene_, "-o", out, "--device", "99"}), 4, "99");
    expectFailure(runProgram({"devices", "--device", "voodoo"}, {}), 4, "voodoo");
    ProgramOptions wish;
    wish.environment["CALOTYPE_DEVICE"] = "voodoo";
    expectFailure(runProgram({"render", scene_, "-o", out}, wish), 4, "CALOTYPE_DEVICE");
    ProgramOptions noDriver;
    noDriver.environment["VK_ICD_FILENAMES"] = "/nonexistent.json";
    noDriver.environment["VK_DRIVER_FILES"] = "/nonexistent.json";
    expectFailure(runProgram({"render", scene_, "-o", out}, noDriver), 4, "Vulkan");
}

// No device has images of 65535 pixels on a side.
TEST_F(ExitCodeTest, SizeBeyondTheDevice) {
    expectFailure(runProgram({"render", scene_, "-o", folder_ / "out.png", "--size", "65535x2"}), 4,
                  "pixels on a side");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
}

// Known before rendering starts: at these sizes rendering would take hours.
TEST_F(ExitCodeTest, UnwritableOutput) {
    const std::vector<std::string> large = {"--size", "4000x4000", "--spp", "100000"};
    const auto render = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), large.begin(), large.end());
        return runProgram(arguments);
    };
    const std::string good = folder_ / "good.png";
    expectFailure(render({"render", scene_, "-o", folder_ / "no/such/folder.png"}), 6,
                  "folder.png");
    expectFailure(render({"render", scene_, "-o", good, "-o", "/proc/x.exr"}), 6, "/proc/x.exr");
    expectFailure(render({"render", scene_, "-o", good, "--stats", folder_ / "no/stats.json"}), 6,
                  "stats.json");
    expectFailure(render({"render", scene_, "-o", good, "--preview-every", "1", "--preview-file",
                          folder_ / "no/preview.png"}),
                  6, "preview.png");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
}

} // namespace
} // namespace calotype::test
