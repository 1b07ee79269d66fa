// What `calotype render` writes and says.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <thread>

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "image/exr.h"
#include "image/pfm.h"
#include "settings/setting_kinds.h"
#include "settings/settings_table.h"
#include "support/image_means.h"

namespace calotype::test {
namespace {

using RenderTest = CliTest;

TEST_F(RenderTest, WritesEveryFormatAlike) {
    const std::string png = folder_ / "a.png";
    const std::string exr = folder_ / "a.EXR";
    const std::string pfm = folder_ / "a.pfm";
    const ProgramResult result =
        runProgram({"render", scene_, "-o", png, "-o", exr, "-o", pfm, "--seed", "7"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_TRUE(result.output.empty()) << result.output;
    EXPECT_EQ(readText(png).substr(1, 3), "PNG");
    const Image a = readExr(exr);
    const Image b = readPfm(pfm);
    EXPECT_EQ(a.width, 32u);
    EXPECT_EQ(a.height, 24u);
    EXPECT_EQ(a.pixels, b.pixels);
    EXPECT_GT(imageMean(a).y, 0.01);
}

/// An attribute of an EXR file as text, or "(none)".
std::string attributeOf(const Imf::Header& header, const std::string& name) {
    if (const auto* text = header.findTypedAttribute<Imf::StringAttribute>("calotype:" + name))
        return text->value();
    if (const auto* number = header.findTypedAttribute<Imf::DoubleAttribute>("calotype:" + name))
        return shortestText(number->value());
    if (const auto* number = header.findTypedAttribute<Imf::IntAttribute>("calotype:" + name))
        return std::to_string(number->value());
    return "(none)";
}

TEST_F(RenderTest, ExrSaysHowItWasMade) {
    const std::string exr = folder_ / "a.exr";
    const ProgramResult result =
        runProgram({"render", scene_, "-o", exr, "--spp", "3", "--seed", "4000000000", "--sampler",
                    "independent", "--mis", "off", "--clamp-indirect", "2.5"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const Imf::InputFile file(exr.c_str());
    const Imf::Header& header = file.header();
    const std::map<std::string, std::string> expected = {{"spp", "3"},
                                                         {"seed", "4e+09"},
                                                         {"sampler", "independent"},
                                                         {"mis", "off"},
                                                         {"clamp_indirect", "2.5"},
                                                         {"size", "32x24"},
                                                         {"version", CALOTYPE_VERSION}};
    for (const auto& [name, text] : expected)
        EXPECT_EQ(attributeOf(header, name), text) << name;
    EXPECT_EQ(attributeOf(header, "sceneHash").size(), 16u);
    // With the keys of scene files. The camera looks down by 0.5 on 4, so up is (0, 8, -1) /
    // sqrt(65).
    const auto camera = nlohmann::json::parse(attributeOf(header, "camera"));
    EXPECT_EQ(camera["type"], "perspective");
    EXPECT_EQ(camera["position"], nlohmann::json({0.0, 1.0, 4.0}));
    EXPECT_EQ(camera["fov"], 40.0);
    EXPECT_EQ(camera["lens_radius"], 0.0);
    const std::vector<double> target = camera["target"];
    const std::vector<double> up = camera["up"];
    const double expectedTarget[] = {0.0, 0.5, 0.0};
    const double expectedUp[] = {0.0, 8.0 / std::sqrt(65.0), -1.0 / std::sqrt(65.0)};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(target[i], expectedTarget[i], 1e-11);
        EXPECT_NEAR(up[i], expectedUp[i], 1e-11);
    }
    for (const Setting& setting : settingsTable())
        if (setting.changesSamples)
            EXPECT_NE(attributeOf(header, setting.name), "(none)") << setting.name;
}

// Without times and without anything else of the run.
TEST_F(RenderTest, EqualRendersWriteEqualFiles) {
    for (const std::string run : {"1", "2"})
        EXPECT_EQ(runProgram({"render", scene_, "-o", folder_ / (run + ".exr"), "-o",
                              folder_ / (run + ".png"), "-o", folder_ / (run + ".pfm"), "--film",
                              folder_ / (run + ".film"), "--spp", "16", "--aov", "normal,error"})
                      .exitCode,
                  0);
    for (const std::string ending : {".exr", ".png", ".pfm", ".film"}) {
        EXPECT_GT(readText(folder_ / ("1" + ending)).size(), 100u);
        EXPECT_TRUE(readText(folder_ / ("1" + ending)) == readText(folder_ / ("2" + ending)))
            << ending;
    }
}

TEST_F(RenderTest, CommandLineOverridesTheScene) {
    const std::string first = folder_ / "a.pfm";
    const std::string second = folder_ / "b.pfm";
    runProgram({"render", scene_, "-o", first, "--spp", "2", "--max-bounces", "1", "--seed", "3",
                "--size", "20x10"});
    runProgram({"render", scene_, "-o", second, "--set", "/render/spp=2", "--set",
                "/render/max_bounces=1", "--set", "/render/seed=3", "--set", "/film/width=20",
                "--set", "/film/height=10"});
    EXPECT_EQ(readPfm(first).width, 20u);
    EXPECT_EQ(readText(first), readText(second));
}

TEST_F(RenderTest, ThreadsDoNotChangeThePicture) {
    const std::string first = folder_ / "a.pfm";
    const std::string second = folder_ / "b.pfm";
    EXPECT_EQ(runProgram({"render", scene_, "-o", first, "--threads", "1"}).exitCode, 0);
    EXPECT_EQ(runProgram({"render", scene_, "-o", second, "--threads", "2"}).exitCode, 0);
    EXPECT_GT(imageMean(readPfm(first)).y, 0.01);
    EXPECT_EQ(readText(first), readText(second));
}

TEST_F(RenderTest, StatsSayWhatWasDone) {
    const std::string stats = folder_ / "stats.json";
    const ProgramResult result = runProgram({"render", scene_, "-o", folder_ / "a.png", "--stats",
                                             stats, "--crop", "4,2,16,8", "--sampler", "sobol"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto json = nlohmann::json::parse(readText(stats));
    EXPECT_EQ(json["resolution"], nlohmann::json({32, 24}));
    EXPECT_EQ(json["crop"], nlohmann::json({4, 2, 16, 8}));
    EXPECT_EQ(json["spp"], 4);
    EXPECT_EQ(json["sampler"], "sobol");
    EXPECT_EQ(json["paths"], 16 * 8 * 4);
    EXPECT_GE(json["rays"], 16 * 8 * 4);
    EXPECT_EQ(json["non_finite_samples"], 0);
    EXPECT_FALSE(json["device"].get<std::string>().empty());
    EXPECT_FALSE(json["driver"].get<std::string>().empty());
    EXPECT_GT(json["peak_memory_bytes"], 1 << 20);
    for (const char* stage :
         {"load", "build", "upload", "compile", "first_sample", "render", "write"})
        EXPECT_GT(json["seconds"][stage].get<double>(), 0.0) << stage;
    EXPECT_GT(json["seconds"]["first_sample"], json["seconds"]["compile"]);
}

TEST_F(RenderTest, SamplersDrawOtherNumbers) {
    for (const char* device : {"", "reference"}) {
        const auto picture = [&](const char* sampler) {
            const std::string file = folder_ / "sampled.pfm";
            EXPECT_EQ(
                runProgram({"render", scene_, "-o", file, "--device", device, "--sampler", sampler})
                    .exitCode,
                0);
            return readText(file);
        };
        EXPECT_NE(picture("independent"), picture("sobol")) << "device '" << device << "'";
    }
}

// Off a terminal, with the program's pace: a summary and no control characters.
TEST_F(RenderTest, OffATerminalThereAreFewPlainLines) {
    const ProgramResult result = runProgram({"render", scene_, "-o", folder_ / "a.png"});
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_EQ(result.errors.find('\r'), std::string::npos);
    EXPECT_EQ(result.errors.find('\033'), std::string::npos);
    EXPECT_NE(result.errors.find("4 of 4 samples"), std::string::npos);
    EXPECT_TRUE(runProgram({"render", scene_, "-o", folder_ / "a.png", "-q"}).errors.empty());
}

TEST_F(RenderTest, OnATerminalThereIsABar) {
    ProgramOptions options;
    options.onTerminal = true;
    options.columns = 132;
    options.environment["TERM"] = "xterm";
    const ProgramResult result =
        runProgram({"render", scene_, "-o", folder_ / "a.png", "--spp", "2048"}, options);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.errors.find("\r\033[K["), std::string::npos) << result.errors;
    for (const char* word : {"/2048 spp", "error ", "samples/s", "rays/s", "elapsed", "left"})
        EXPECT_NE(result.errors.find(word), std::string::npos) << word;
}

TEST_F(RenderTest, SceneWithoutLightIsABlackPictureWithAWarning) {
    const std::string scene = folder_.write(
        "dark.json",
        R"({ "camera": { "position": [0, 0, 0] }, "film": { "width": 8, "height": 8 } })");
    const std::string out = folder_ / "dark.pfm";
    const ProgramResult result = runProgram({"render", scene, "-o", out, "--spp", "2"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.errors.find("warning"), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find("black"), std::string::npos) << result.errors;
    for (const glm::vec3& pixel : readPfm(out).pixels)
        EXPECT_EQ(pixel, glm::vec3(0.0f));
}

// Whole at every moment: whenever one looks, the preview is absent or a complete picture.
TEST_F(RenderTest, PreviewsAreWholeAtEveryMoment) {
    const std::string preview = folder_ / "preview.pfm";
    size_t looks = 0;
    std::vector<std::string> versions;
    ProgramOptions options;
    options.whileRunning = [&](int, double) {
        if (!std::filesystem::exists(preview))
            return;
        const std::string bytes = readText(preview);
        EXPECT_EQ(bytes.size(), std::string("PF\n32 24\n-1.0\n").size() + 32 * 24 * 12);
        ++looks;
        if (versions.empty() || versions.back() != bytes)
            versions.push_back(bytes);
    };
    const ProgramResult result =
        runProgram({"render", scene_, "-o", folder_ / "a.png", "--spp", "1024", "--preview-every",
                    "16", "--preview-file", preview},
                   options);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_GT(looks, 0u);
    EXPECT_GT(versions.size(), 1u);
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.png", "preview.pfm", "scene.json"}));
}

TEST_F(RenderTest, PreviewsBySeconds) {
    const std::string preview = folder_ / "preview.png";
    const ProgramResult result =
        runProgram({"render", scene_, "-o", folder_ / "a.png", "--spp", "2048", "--preview-every",
                    "0.1s", "--preview-file", preview});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_TRUE(std::filesystem::exists(preview));
}

/// A render of hours. Its first preview says that it is under way; then `interrupt` is called once
/// with the program's id.
class InterruptTest : public CliTest {
protected:
    ProgramResult runInterrupted(const std::function<void(int)>& interrupt) {
        ProgramOptions options;
        options.whileRunning = [&](int pid, double seconds) {
            if (interruptedAt_ == 0.0 && std::filesystem::exists(preview_)) {
                interrupt(pid);
                interruptedAt_ = seconds;
            }
        };
        return runProgram({"render", scene_, "-o", out_, "--size", "640x480", "--spp", "1000000",
                           "--stats", stats_, "--preview-every", "1", "--preview-file", preview_},
                          options);
    }

    double interruptedAt_ = 0.0; ///< seconds of the program's age
    const std::string out_ = folder_ / "a.pfm";
    const std::string stats_ = folder_ / "stats.json";
    const std::string preview_ = folder_ / "preview.png";
};

TEST_F(InterruptTest, WritesWhatThereIsWithinASecond) {
    const ProgramResult result = runInterrupted([](int pid) { kill(pid, SIGINT); });
    EXPECT_EQ(result.exitCode, 1) << result.errors;
    EXPECT_LT(result.seconds - interruptedAt_, 1.0);
    EXPECT_NE(result.errors.find("interrupted after"), std::string::npos) << result.errors;
    EXPECT_GT(imageMean(readPfm(out_)).y, 0.0);
    const auto json = nlohmann::json::parse(readText(stats_));
    EXPECT_GE(json["spp"], 1);
    EXPECT_LT(json["spp"], 1000000);
}

// As from `timeout`, which signals the program and again its process group.
TEST_F(InterruptTest, SignalsAtOnceAreOneWish) {
    const ProgramResult result = runInterrupted([](int pid) {
        kill(pid, SIGINT);
        kill(pid, SIGTERM);
    });
    EXPECT_EQ(result.exitCode, 1) << result.errors;
    EXPECT_GT(imageMean(readPfm(out_)).y, 0.0);
}

/// Whether a signal waits for a thread of the process to take it.
bool isPending(int pid, int signal) {
    const std::string status = readText("/proc/" + std::to_string(pid) + "/status");
    const std::string key = "ShdPnd:";
    const uint64_t pending = std::stoull(status.substr(status.find(key) + key.size()), nullptr, 16);
    return (pending >> (signal - 1) & 1) != 0;
}

// The system sends SIGXCPU every second, and a shell and the system both send SIGHUP.
TEST_F(InterruptTest, SignalsOfSystemsMayComeAgain) {
    const ProgramResult result = runInterrupted([](int pid) {
        for (const int signal : {SIGXCPU, SIGHUP}) {
            kill(pid, signal);
            while (isPending(pid, signal))
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            std::this_thread::sleep_for(std::chrono::milliseconds(10)); // for the handler
            kill(pid, SIGSTOP);
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            kill(pid, signal);
            kill(pid, SIGCONT);
        }
    });
    EXPECT_EQ(result.exitCode, 1) << result.errors;
    EXPECT_GT(imageMean(readPfm(out_)).y, 0.0);
}

// Stopped between the two signals, so that it cannot have ended by itself before the second. The
// test looks at how it ends, and that it writes nothing. How long a killed process takes to end
// depends on the system.
TEST_F(InterruptTest, LaterSignalEndsAtOnce) {
    const ProgramResult result = runInterrupted([](int pid) {
        kill(pid, SIGINT);
        while (isPending(pid, SIGINT))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        std::this_thread::sleep_for(std::chrono::milliseconds(10)); // for the handler
        kill(pid, SIGSTOP);
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        kill(pid, SIGTERM);
        kill(pid, SIGCONT);
    });
    EXPECT_EQ(result.exitCode, 128 + SIGTERM) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(out_));
}

// A line for each update; the last lines are text.
TEST_F(RenderTest, ProgressCanBeJson) {
    const std::string film = folder_ / "a.film";
    const ProgramResult result =
        runProgram({"render", scene_, "-o", folder_ / "a.png", "-o", folder_ / "a.exr", "--film",
                    film, "--time", "1.5s", "--progress", "json", "--from", "-1,2,4"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    std::istringstream lines(result.errors);
    std::string line;
    int updates = 0;
    nlohmann::json last;
    while (std::getline(lines, line) && line.starts_with('{')) {
        const auto json = last = nlohmann::json::parse(line);
        EXPECT_GE(json["done"], 0.0);
        EXPECT_LE(json["done"], 1.0);
        EXPECT_GE(json["seconds"], 0.0);
        updates += json["stage"] == "rendering" ? 1 : 0;
        if (json["stage"] == "rendering")
            EXPECT_GT(json["spp"], 0);
    }
    EXPECT_GE(updates, 1) << result.errors;
    EXPECT_EQ(last["stage"], "finished");
    EXPECT_EQ(last["done"], 1.0);
    // The summary names every file that holds the picture.
    for (const char* name : {"/a.png, ", "/a.exr, ", "/a.film: "})
        EXPECT_NE(line.find(name), std::string::npos) << line;
}

TEST_F(RenderTest, SaysWhenSamplesAreTooFewForTheError) {
    const ProgramResult few =
        runProgram({"render", scene_, "-o", folder_ / "a.png", "--spp", "64"});
    EXPECT_NE(few.errors.find("% (too few samples to tell)"), std::string::npos) << few.errors;
    const ProgramResult more =
        runProgram({"render", scene_, "-o", folder_ / "a.png", "--spp", "128"});
    EXPECT_EQ(more.errors.find("too few"), std::string::npos) << more.errors;
}

} // namespace
} // namespace calotype::test
