// Films of renders that end early, by a signal or a kill: what the film holds is kept.
#include <csignal>
#include <filesystem>
#include <optional>
#include <random>
#include <utility>

#include "cli/film_cli_test.h"
#include "support/slow_run.h"

namespace calotype::test {
namespace {

// All signals that end programs keep the film, and the exit code says that it is not done.
TEST_F(FilmTest, SignalsKeepTheFilm) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGUSR2}) {
        const std::string path = folder_ / ("film" + std::to_string(signal));
        ProgramOptions options;
        bool isSent = false;
        options.whileRunning = [&](int pid, double) {
            // Once the film has a block; the first thing that is written holds none.
            if (!isSent && std::filesystem::exists(path) &&
                readFilm(path).film.samplesPerPixel() > 0)
                isSent = kill(pid, signal) == 0;
        };
        const ProgramResult result = runProgram(
            render({"--film", path, "--spp", "1000000", "--checkpoint", "0.1s"}), options);
        EXPECT_EQ(result.exitCode, 1) << result.errors;
        EXPECT_NE(result.errors.find("its whole blocks of 16 samples are in the film"),
                  std::string::npos)
            << result.errors;
        const uint64_t samples = readFilm(path).film.samplesPerPixel();
        EXPECT_GT(samples, 0u);
        if (signal == SIGHUP) // all are handled alike
            expectSameFilm(path, film("whole", {"--spp", std::to_string(samples)}));
    }
}

// As by nohup: the render goes on until another signal ends it.
TEST_F(FilmTest, IgnoredSignalsStayIgnored) {
    const std::string path = folder_ / "a.film";
    const auto samples = [&] {
        return std::filesystem::exists(path) ? readFilm(path).film.samplesPerPixel() : 0;
    };
    uint64_t samplesAtHangup = 0;
    bool isEnded = false;
    ProgramOptions options;
    options.ignoredSignals = {SIGHUP};
    options.whileRunning = [&](int pid, double) {
        const uint64_t now = samples();
        if (samplesAtHangup == 0 && now > 0) {
            samplesAtHangup = now;
            kill(pid, SIGHUP);
        } else if (!isEnded && samplesAtHangup > 0 && now > samplesAtHangup + 64) {
            isEnded = kill(pid, SIGTERM) == 0;
        }
    };
    const ProgramResult result =
        runProgram(render({"--film", path, "--spp", "1000000", "--checkpoint", "0.02s"}), options);
    EXPECT_EQ(result.exitCode, 1) << result.errors;
    EXPECT_TRUE(isEnded);
    EXPECT_GT(samples(), samplesAtHangup + 64);
}

/// Kills the program at a random moment: at an age of up to 0.6 s, or, every other time, up to 0.1
/// s after the film has changed, however long that takes.
class Killer {
public:
    Killer(std::string film, std::mt19937& random) : film_(std::move(film)), before_(changedAt()) {
        std::uniform_real_distribution<double> unit;
        waitsForFilm_ = random() % 2 == 0;
        delay_ = unit(random) * (waitsForFilm_ ? 0.1 : 0.6);
    }

    void operator()(int pid, double age) {
        if (waitsForFilm_ && changedAt() != before_) {
            waitsForFilm_ = false;
            delay_ += age;
        }
        if (!waitsForFilm_ && age >= delay_)
            kill(pid, SIGKILL);
    }

private:
    std::optional<std::filesystem::file_time_type> changedAt() const {
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(film_, missing);
        return missing ? std::nullopt : std::optional(time);
    }

    std::string film_;
    std::optional<std::filesystem::file_time_type> before_;
    bool waitsForFilm_ = false;
    double delay_ = 0.0;
};

// Killed at any moment, of loading, of rendering, of writing, the film goes on to the same bits.
TEST_F(FilmTest, SurvivesKills) {
    const int wanted = quickOrFull(8, 50);
    const std::vector<std::string> options = {"--spp", quickOrFull("1536", "8192"), "--size",
                                              "64x48"};
    const std::string whole = film("whole", options);
    const std::string path = folder_ / "killed.film";
    std::mt19937 random(11);
    int kills = 0;
    int killsAfterProgress = 0;
    uint64_t before = 0;
    bool isDone = false;
    for (int run = 0; run < 4 * wanted && !(isDone && kills >= wanted); ++run) {
        if (isDone) { // too soon: once more from the start
            expectSameFilm(path, whole);
            std::filesystem::remove(path);
            before = 0;
        }
        ProgramOptions program;
        if (kills < wanted)
            program.whileRunning = Killer(path, random);
        std::vector<std::string> arguments = render(options);
        arguments.insert(arguments.end(), {"--film", path, "--checkpoint", "0.02s"});
        const ProgramResult result = runProgram(arguments, program);
        isDone = result.exitCode == 0;
        if (!isDone) {
            ASSERT_EQ(result.exitCode, 128 + SIGKILL) << result.errors;
            ++kills;
        }
        if (std::filesystem::exists(path)) {
            const uint64_t samples = readFilm(path).film.samplesPerPixel();
            EXPECT_GE(samples, before) << "nothing that was kept is lost";
            killsAfterProgress += !isDone && samples > before ? 1 : 0;
            before = samples;
        }
    }
    EXPECT_GE(kills, wanted);
    EXPECT_GE(killsAfterProgress, quickOrFull(1, 10));
    ASSERT_TRUE(isDone);
    expectSameFilm(path, whole);
    RecordProperty("kills_after_progress", killsAfterProgress);
}
ALSO_SLOW(FilmTest, SurvivesKills);

} // namespace
} // namespace calotype::test
