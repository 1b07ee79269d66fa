// What is shown on terminals as they are: narrow, dumb, without a width, closed.
#include <algorithm>
#include <filesystem>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/cli_test.h"

namespace calotype::test {
namespace {

class TerminalTest : public CliTest {
protected:
    /// What a render that takes long enough for some updates writes to the terminal.
    std::string shownOn(ProgramOptions options, const std::vector<std::string>& more = {}) {
        options.onTerminal = true;
        options.environment.emplace("TERM", "xterm");
        std::vector<std::string> arguments = {"render",          scene_,  "-o",
                                              folder_ / "a.png", "--spp", "2048"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = runProgram(arguments, options);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return result.errors;
    }

    /// The texts between two returns to the start of the line.
    static std::vector<std::string> bars(const std::string& shown) {
        const std::string clear = "\r\033[K";
        std::vector<std::string> bars;
        for (size_t at = shown.find(clear); at != std::string::npos;) {
            const size_t start = at + clear.size();
            at = shown.find(clear, start);
            if (at != std::string::npos)
                bars.push_back(shown.substr(start, at - start));
        }
        return bars;
    }

    static std::string longestBar(const std::string& shown) {
        const std::vector<std::string> all = bars(shown);
        const auto longest = std::ranges::max_element(all, {}, &std::string::size);
        return longest == all.end() ? "" : *longest;
    }
};

TEST_F(TerminalTest, BarsFitIntoOneLine) {
    for (const int columns : {132, 60, 20, 1}) {
        ProgramOptions options;
        options.columns = static_cast<uint16_t>(columns);
        const std::string bar = longestBar(shownOn(options));
        EXPECT_GT(bar.size(), 0u) << columns;
        EXPECT_LT(bar.size(), std::max<size_t>(columns, 2)) << columns << ": " << bar;
        if (columns >= 60)
            for (const char* part : {"[", "%", "/2048 spp", "left"})
                EXPECT_NE(bar.find(part), std::string::npos) << columns << ": " << bar;
    }
}

// The terminal may be made smaller at any time.
TEST_F(TerminalTest, BarsFollowTheWidth) {
    ProgramOptions options;
    options.columns = 100;
    bool isResized = false;
    const std::string preview = folder_ / "preview.pfm"; // half of the samples are done
    options.whileRunning = [&](int pid, double) {
        if (isResized || !std::filesystem::exists(preview))
            return;
        const std::string terminal = "/proc/" + std::to_string(pid) + "/fd/2";
        const int descriptor = open(terminal.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
        const winsize size{.ws_row = 24, .ws_col = 40, .ws_xpixel = 0, .ws_ypixel = 0};
        isResized = ioctl(descriptor, TIOCSWINSZ, &size) == 0;
        close(descriptor);
    };
    const std::string shown =
        shownOn(options, {"--preview-every", "1024", "--preview-file", preview});
    EXPECT_TRUE(isResized);
    EXPECT_GT(longestBar(shown).size(), 40u);
    ASSERT_FALSE(bars(shown).empty());
    EXPECT_LT(bars(shown).back().size(), 40u) << bars(shown).back();
}

TEST_F(TerminalTest, WithoutAWidthItIsThatOfTheVariableOrEighty) {
    ProgramOptions options;
    options.environment["COLUMNS"] = "50";
    EXPECT_LT(longestBar(shownOn(options)).size(), 50u);
    options.environment["COLUMNS"] = "many";
    const std::string bar = longestBar(shownOn(options));
    EXPECT_GT(bar.size(), 50u) << bar;
    EXPECT_LT(bar.size(), 80u) << bar;
}

TEST_F(TerminalTest, DumbOnesGetPlainLines) {
    for (const char* term : {"dumb", ""}) {
        ProgramOptions options;
        options.columns = 80;
        options.environment["TERM"] = term;
        const std::string shown = shownOn(options);
        EXPECT_EQ(shown.find('\033'), std::string::npos) << shown;
        // A terminal shows line ends as "\r\n".
        EXPECT_EQ(std::ranges::count(shown, '\r'), std::ranges::count(shown, '\n')) << shown;
        EXPECT_NE(shown.find("2048 of 2048 samples"), std::string::npos) << shown;
    }
}

// Messages then go nowhere, and not into the first file that is opened.
TEST_F(TerminalTest, ClosedStreamsLoseNoOutput) {
    ASSERT_EQ(runProgram({"render", scene_, "-o", folder_ / "a.pfm"}).exitCode, 0);
    ProgramOptions options;
    options.closedStreams = {0, 1, 2};
    const ProgramResult result = runProgram({"render", scene_, "-o", folder_ / "b.pfm"}, options);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_TRUE(readText(folder_ / "a.pfm") == readText(folder_ / "b.pfm"));
    // A result on standard output is lost there, and the exit code says so.
    EXPECT_EQ(runProgram({"info", scene_}, options).exitCode, 6);
}

} // namespace
} // namespace calotype::test
