// What the program says of itself.
#include <regex>

#include "cli/cli_test.h"
#include "settings/settings_table.h"
#include "support/paths.h"

namespace calotype::test {
namespace {

TEST(HelpTest, PageOfTheCommandLineIsUpToDate) {
    const ProgramResult result = runProgram({"--help-markdown"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(readText(std::string(kProjectFolder) + "/docs/command-line.md"), result.output)
        << "write it anew: build/calotype --help-markdown > docs/command-line.md";
}

TEST(HelpTest, EveryCommandHasItsSettingsByGroupAndAnExample) {
    const std::pair<const char*, SettingCommand> commands[] = {{"render", kRenderCommand},
                                                               {"study", kStudyCommand},
                                                               {"bench", kBenchCommand},
                                                               {"info", kInfoCommand}};
    for (const auto& [command, bit] : commands) {
        SCOPED_TRACE(command);
        const std::string help = runProgram({command, "--help"}).output;
        for (const Setting& setting : settingsTable()) {
            // With a space or an end after it: --spp is no --sppx.
            const std::regex option(setting.option() + "(\\s|$)");
            if (setting.commands & bit) {
                EXPECT_TRUE(std::regex_search(help, option)) << setting.option();
                EXPECT_NE(help.find(std::string(nameOf(setting.group)) + ":"), std::string::npos);
            }
        }
    }
    for (const char* command : {"render", "study", "bench", "info", "merge", "compare"})
        EXPECT_NE(runProgram({command, "--help"}).output.find("Example: "), std::string::npos)
            << command;
}

} // namespace
} // namespace calotype::test
