// A signal before the first sample ends the program soon, whatever it is doing, and nothing is
// written.
#include <csignal>
#include <fstream>
#include <optional>

#include "cli/cli_test.h"

namespace calotype::test {
namespace {

/// Whether the program is ready for signals: it catches SIGALRM, by which it ends itself.
bool catchesAlarms(int pid) {
    std::ifstream status("/proc/" + std::to_string(pid) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("SigCgt:"))
            return (std::stoull(line.substr(7), nullptr, 16) >> (SIGALRM - 1) & 1) != 0;
    return false;
}

class LoadingInterruptTest : public CliTest {
protected:
    /// Interrupts the program as soon as it is ready for it, expects the message, and returns the
    /// seconds until it ends.
    double secondsToEnd(const std::string& scene) {
        std::optional<double> signalled;
        ProgramOptions options;
        options.whileRunning = [&](int pid, double age) {
            if (!signalled && catchesAlarms(pid) && kill(pid, SIGINT) == 0)
                signalled = age;
        };
        const ProgramResult result = runProgram(
            {"render", scene, "-o", folder_ / "out.png", "--spp", "1", "--film", folder_ / "film"},
            options);
        expectFailure(result, 1, "interrupted before the first sample; nothing was written");
        EXPECT_EQ(std::ranges::count(folder_.names(), "out.png"), 0);
        EXPECT_EQ(std::ranges::count(folder_.names(), "film"), 0);
        for (const std::string& name : folder_.names())
            EXPECT_EQ(name.find("calotype-lock"), std::string::npos) << name;
        return result.seconds - signalled.value_or(0.0);
    }
};

// Its parts look for the signal.
TEST_F(LoadingInterruptTest, EndsTheReadingOfAModelTimed) {
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 400'000; ++i)
        obj += "v 1 2 3\nf -1 -2 -3\n";
    EXPECT_LT(secondsToEnd(folder_.write("large.obj", obj)), 1.0);
}

// JSON is read in one step, which takes seconds here.
TEST_F(LoadingInterruptTest, EndsStepsThatCannotBeStoppedTimed) {
    std::string spheres;
    for (int i = 0; i < 300'000; ++i)
        spheres += R"({ "type": "sphere", "radius": 1, "material": "grey" },)";
    std::string scene = kSmallScene;
    scene.insert(scene.find("\"shapes\": [") + 11, spheres);
    EXPECT_LT(secondsToEnd(folder_.write("large.json", scene)), 1.0);
}

} // namespace
} // namespace calotype::test
