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

TEST(HelpTest, EveryCommandHasItsSettingsByGroup) {
    const std::pair<const char*, SettingCommand> commands[] = {{"render", kRenderCommand},
                                                               {"study", kStudyCommand},
                                                               {"bench", kBenchCommand},
                                                               {"info", kInfoCommand},
                                                               {"merge", kMergeCommand}};
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
}

// The commands are those that the help lists.
TEST(HelpTest, EveryCommandHasAnExampleOfItself) {
    const std::string help = runProgram({"--help"}).output;
    EXPECT_NE(help.find("Example: calotype render "), std::string::npos) << help;
    const size_t list = help.find("Subcommands:");
    ASSERT_NE(list, std::string::npos);
    const std::regex command("\\n  ([a-z]+) ");
    size_t count = 0;
    for (std::sregex_iterator it(help.begin() + list, help.end(), command), end; it != end; ++it) {
        const std::string name = (*it)[1];
        const std::string page = runProgram({name, "--help"}).output;
        const size_t example = page.find("Example: ");
        ASSERT_NE(example, std::string::npos) << page;
        EXPECT_NE(page.find("calotype " + name + " ", example), std::string::npos) << page;
        ++count;
    }
    EXPECT_EQ(count, 10u);
}

} // namespace
} // namespace calotype::test
