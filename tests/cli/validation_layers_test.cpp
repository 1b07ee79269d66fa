// The program with the Vulkan validation layers, any message of which is an error.
#include "cli/cli_test.h"

namespace calotype::test {
namespace {

using ValidationLayersTest = CliTest;

// Each kernel and each kind of session: the other tests of this folder run without the layers.
TEST_F(ValidationLayersTest, FindNothingInAnyCommand) {
    const std::vector<std::vector<std::string>> commands = {
        {"render", scene_, "-q", "-o", folder_ / "a.exr", "--aov", "normal,error"},
        {"render", scene_, "-q", "-o", folder_ / "a.png", "--adaptive", "--spp", "256"},
        {"render", scene_, "-q", "--film", folder_ / "a.film", "--crop", "5,3,16,9"},
        {"bench", scene_, "--repeats", "1", "--spp", "1"},
    };
    ProgramOptions options;
    options.environment = {{"CALOTYPE_VALIDATION", "1"}};
    for (const std::vector<std::string>& arguments : commands) {
        const ProgramResult result = runProgram(arguments, options);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_EQ(result.errors, "");
    }
}

} // namespace
} // namespace calotype::test
