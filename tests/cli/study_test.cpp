// calotype study: what it writes, what it says, and what is left of it when it is interrupted.
#include <csignal>
#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "support/paths.h"
#include "support/slow_run.h"

namespace calotype::test {
namespace {

class StudyTest : public CliTest {
protected:
    ProgramResult study(const std::vector<std::string>& more, const ProgramOptions& options = {}) {
        std::vector<std::string> arguments = {"study", scene_, "-q", "-o", folder_ / "out"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runProgram(arguments, options);
    }

    std::string readOutput(const std::string& name) const {
        return readText((folder_.path() / "out" / name).string());
    }
};

TEST_F(StudyTest, TimedRunWritesTableAndPlotAndPage) {
    // Its error is spread over all pixels, so that few samples measure it well.
    scene_ = std::string(kProjectFolder) + "/scenes/cornell-box.json";
    const int budget = quickOrFull(10, 20);
    const ProgramResult result =
        study({"--budget", std::to_string(budget) + "s", "--size", quickOrFull("20x20", "32x32")});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_LT(result.seconds, 1.25 * budget);
    for (const char* line : {"5 % error: ", "2 % error: ", "1 % error: ", "study.html"})
        EXPECT_NE(result.output.find(line), std::string::npos) << result.output;
    const std::string csv = readOutput("study.csv");
    const std::string page = readOutput("study.html");
    EXPECT_EQ(readOutput("study.svg").rfind("<svg", 0), 0u);
    const auto json = nlohmann::json::parse(readOutput("study.json"));
    EXPECT_EQ(json["format"], 1);
    ASSERT_EQ(json["recommended"].size(), 3u);
    for (const auto& choice : json["recommended"])
        if (!choice["command"].is_null())
            EXPECT_NE(result.output.find(choice["command"].get<std::string>()), std::string::npos)
                << "a command a row: " << result.output;
    EXPECT_EQ(json["measurements"][0]["name"], "the default");
    EXPECT_GT(json["measurements"][0]["curve"].size(), 3u);
    // A busy machine does not get through all settings in the quick run's time; then it says so.
    const bool isWhole = result.errors.find("too short for all settings") == std::string::npos;
    EXPECT_TRUE(isWhole || !isSlowRun()) << result.errors;
    for (const char* option :
         {"--adaptive", "--sampler independent", "--roulette off", "--mis off", "--max-bounces 3",
          "--clamp-indirect", "--light-choice uniform", "--bvh median"}) {
        EXPECT_TRUE(!isWhole || csv.find(option) != std::string::npos) << option;
        EXPECT_TRUE(!isWhole || page.find(option) != std::string::npos) << option;
    }
    // Denoised variants: measured, or named with a reason.
    for (const char* name : {"denoised by oidn", "denoised by statistical"}) {
        const bool isMeasured = csv.find(name) != std::string::npos;
        const bool isNamed =
            result.errors.find(std::string("not measured: ") + name) != std::string::npos;
        EXPECT_TRUE(!isWhole || isMeasured != isNamed) << name << result.errors;
        EXPECT_TRUE(!isMeasured || page.find("stated and true error") != std::string::npos);
        EXPECT_TRUE(!isMeasured ||
                    result.output.find("5 % error after denoising: ") != std::string::npos)
            << result.output;
    }
    // The last line of the default: what the ground truth says is what the picture said of itself.
    std::istringstream lines(csv);
    std::vector<std::string> last;
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("\"the default\"", 0) == 0) {
            std::istringstream fields(line);
            last.clear();
            for (std::string field; std::getline(fields, field, ',');)
                last.push_back(field);
        }
    ASSERT_GE(last.size(), 7u);
    ASSERT_FALSE(last[5].empty() || last[6].empty()) << "too slow a machine for so many samples";
    EXPECT_NEAR(std::stod(last[5]) / std::stod(last[6]), 1.0, 0.15) << last[5] << " " << last[6];
}
ALSO_SLOW(StudyTest, TimedRunWritesTableAndPlotAndPage);

TEST_F(StudyTest, TimedRunInterruptedKeepsWhatItHas) {
    ProgramOptions options;
    bool isSent = false;
    options.whileRunning = [&](int pid, double age) {
        if (!isSent && age > 6.0) // of 8 s the ground truth takes 3, and each variant 0.35
            isSent = kill(pid, SIGINT) == 0;
    };
    const ProgramResult result =
        study({"--budget", "8s", "--set", "/camera/position=[0, 1, 3.2]"}, options);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_LT(result.seconds, 7.5);
    EXPECT_NE(result.errors.find("what was measured so far is in"), std::string::npos)
        << result.errors;
    const std::string page = readOutput("study.html");
    EXPECT_NE(page.find("stopped before its end"), std::string::npos);
    EXPECT_NE(page.find("--set '/camera/position=[0, 1, 3.2]' -o"), std::string::npos)
        << "as a shell takes it";
    EXPECT_NE(readOutput("study.csv").find("the default"), std::string::npos);
}

TEST_F(StudyTest, AnOutputThatFailsLosesNoOther) {
    ProgramOptions options;
    const std::filesystem::path inTheWay = folder_.path() / "out" / "study.svg";
    options.whileRunning = [&](int, double age) {
        if (age > 1.0)
            std::filesystem::create_directories(inTheWay);
    };
    const TestFolder spare;
    options.environment["TMPDIR"] = spare.path();
    const ProgramResult result = study({"--budget", "5s", "--size", "16x16"}, options);
    EXPECT_EQ(result.exitCode, 6);
    EXPECT_NE(result.errors.find("study.svg is kept in '" + spare.path().string()),
              std::string::npos)
        << result.errors;
    ASSERT_EQ(spare.names().size(), 1u);
    EXPECT_EQ(readText(spare / spare.names()[0]).rfind("<svg", 0), 0u);
    EXPECT_NE(readOutput("study.html").find("the default"), std::string::npos);
    EXPECT_NE(readOutput("study.csv").find("the default"), std::string::npos);
}

// Without a library, what it is for is left out, and the scene's own denoiser is turned off.
TEST_F(StudyTest, SaysWhyADenoiserIsNotMeasured) {
    ProgramOptions options;
    options.environment["CALOTYPE_OIDN"] = "/nowhere";
    const ProgramResult result =
        study({"--budget", "5s", "--size", "16x16", "--set", "/render/denoise=\"oidn\""}, options);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(
        result.errors.find("note: not measured: denoised by oidn: needs Open Image Denoise 2"),
        std::string::npos)
        << result.errors;
    EXPECT_NE(result.errors.find("pip install pyoidn"), std::string::npos) << result.errors;
    EXPECT_NE(readOutput("study.html").find("pip install pyoidn"), std::string::npos);
    const auto json = nlohmann::json::parse(readOutput("study.json"));
    EXPECT_EQ(json["omitted"][0]["name"], "denoised by oidn");
    for (const auto& choice : json["recommended"])
        if (!choice["command"].is_null())
            EXPECT_NE(choice["command"].get<std::string>().find("--denoise off"),
                      std::string::npos);
}

TEST_F(StudyTest, SaysThatItsBudgetIsTooShort) {
    const ProgramResult result = study({"--budget", "1s", "--size", "16x16"});
    EXPECT_NE(result.errors.find("too short"), std::string::npos) << result.errors;
    EXPECT_EQ(result.exitCode == 0, std::filesystem::exists(folder_.path() / "out"));
}

TEST_F(StudyTest, MistakesAreNamed) {
    expectFailure(study({"--budget", "0"}), 2, "30s, 5m or 2h");
    expectFailure(study({"--set", "/film/width=0"}), 3, "width");
    expectFailure(runProgram({"study", folder_ / "none.json", "-o", folder_ / "a"}), 3,
                  "none.json");
    folder_.write("file", "");
    expectFailure(runProgram({"study", scene_, "-o", folder_ / "file"}), 6, "file");
    const ProgramResult dark = study({"--budget", "5s", "--set", "/lights=[]"});
    EXPECT_EQ(dark.exitCode, 3);
    EXPECT_NE(dark.errors.find("no light"), std::string::npos) << dark.errors;
}

} // namespace
} // namespace calotype::test
