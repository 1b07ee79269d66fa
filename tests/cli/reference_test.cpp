// `--device reference`: the same picture by the other tracer.
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "image/layers.h"

namespace calotype::test {
namespace {

class ReferenceDeviceTest : public CliTest {
protected:
    ProgramResult render(const std::string& out, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {
            "render", "scenes/cornell-box.json", "--size", "32x32", "--spp", "16", "-o", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runProgram(arguments);
    }
};

TEST_F(ReferenceDeviceTest, RendersThePictureOfTheDevice) {
    const std::string device = folder_ / "device.exr";
    const std::string reference = folder_ / "reference.exr";
    const std::string stats = folder_ / "stats.json";
    ASSERT_EQ(render(device, {}).exitCode, 0);
    const ProgramResult result =
        render(reference, {"--device", "reference", "--threads", "2", "--stats", stats});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto json = nlohmann::json::parse(readText(stats));
    EXPECT_EQ(json["device"], "reference");
    EXPECT_EQ(json["spp"], 16);
    EXPECT_EQ(json["paths"], 32 * 32 * 16);
    const ProgramResult compared =
        runProgram({"compare", device, reference, "--max-relmse", "1e-7"});
    EXPECT_EQ(compared.exitCode, 0) << compared.output;
    ASSERT_EQ(render(device, {"--seed", "1"}).exitCode, 0); // other noise, which compare must see
    EXPECT_EQ(runProgram({"compare", device, reference, "--max-relmse", "1e-7"}).exitCode, 5);
}

TEST_F(ReferenceDeviceTest, WritesLayers) {
    const std::string out = folder_ / "layers.exr";
    const ProgramResult result = render(out, {"--device", "reference", "--aov", "primitive,depth"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const FirstHitImage hits = readFirstHits(out);
    EXPECT_NE(hits.at(16, 16).primitive, kNoPrimitive);
    EXPECT_GT(hits.at(16, 16).depth, 0.0f);
}

TEST_F(ReferenceDeviceTest, IsChosenByTheVariableToo) {
    const std::string stats = folder_ / "stats.json";
    const auto deviceOf = [&](const ProgramOptions& options, const std::string& device) {
        std::vector<std::string> arguments = {
            "render", "scenes/cornell-box.json", "--size",  "8x8", "--spp", "1",
            "-o",     folder_ / "a.exr",         "--stats", stats};
        if (!device.empty())
            arguments.insert(arguments.end(), {"--device", device});
        EXPECT_EQ(runProgram(arguments, options).exitCode, 0);
        return nlohmann::json::parse(readText(stats))["device"].get<std::string>();
    };
    ProgramOptions byVariable;
    byVariable.environment["CALOTYPE_DEVICE"] = "Reference";
    EXPECT_EQ(deviceOf(byVariable, ""), "reference");
    EXPECT_NE(deviceOf(byVariable, "0"), "reference");
    EXPECT_EQ(deviceOf({}, "REFERENCE"), "reference");
    EXPECT_EQ(runProgram({"devices"}, byVariable).exitCode, 0);
    EXPECT_EQ(runProgram({"info", "scenes/cornell-box.json"}, byVariable).exitCode, 0);
}

TEST_F(ReferenceDeviceTest, IsForRenderOnly) {
    for (const char* command : {"info", "devices"}) {
        std::vector<std::string> arguments = {command, "--device", "reference"};
        if (arguments[0] == "info")
            arguments.push_back("scenes/cornell-box.json");
        const ProgramResult result = runProgram(arguments);
        EXPECT_EQ(result.exitCode, 2) << command;
        EXPECT_NE(result.errors.find("only render and study support it"), std::string::npos)
            << result.errors;
    }
}

} // namespace
} // namespace calotype::test
