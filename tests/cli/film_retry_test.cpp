// The same command line again: it continues its film, replaces nothing by less, and loses nothing
// where a disk is full.
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "cli/film_cli_test.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

class FilmRetryTest : public FilmTest {
protected:
    uint64_t samplesOf(const std::string& path) const {
        return readFilm(path).film.samplesPerPixel();
    }

    /// The command by which a message says the result gets to its place.
    static std::string commandIn(const std::string& errors) {
        const std::string before = "when there is room: ";
        const size_t at = errors.find(before);
        if (at == std::string::npos)
            return "";
        const size_t start = at + before.size();
        return errors.substr(start, errors.find('\n', start) - start);
    }

    /// The file that a message says the result is kept in.
    static std::string keptIn(const std::string& errors) {
        const std::string before = "is kept in '";
        const size_t at = errors.find(before);
        if (at == std::string::npos)
            return "";
        const size_t start = at + before.size();
        return errors.substr(start, errors.find('\'', start) - start);
    }
};

TEST_F(FilmRetryTest, AFilmIsContinued) {
    const std::string whole = film("whole", {"--spp", "96"});
    const std::string path = film("a", {"--spp", "32"});
    EXPECT_EQ(runProgram(render({"--film", path, "--spp", "96"})).exitCode, 0);
    expectSameFilm(path, whole);
    // A range of samples beside those that it holds is added to them.
    const std::string part = film("part", {"--samples", "64:96"});
    EXPECT_EQ(runProgram(render({"--film", part, "--samples", "0:64"})).exitCode, 0);
    expectSameFilm(part, whole);
}

TEST_F(FilmRetryTest, AWholeFilmIsLeftAndItsOutputsAreWritten) {
    const std::string path = film("a", {"--spp", "32"});
    const auto written = fs::last_write_time(path);
    for (const char* samples : {"32", "16"}) {
        const std::string picture = folder_ / "a.pfm";
        const ProgramResult result =
            runProgram(render({"--film", path, "--spp", samples, "-o", picture}));
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_EQ(fs::last_write_time(path), written) << "nothing is to be written";
        EXPECT_EQ(runProgram(render({"--spp", "32", "-o", folder_ / "b.pfm"})).exitCode, 0);
        EXPECT_TRUE(readText(picture) == readText(folder_ / "b.pfm"));
        fs::remove(picture);
    }
}

TEST_F(FilmRetryTest, FilmsOfOtherScenesAndSettingsAreRefused) {
    const std::string path = film("a", {"--spp", "32"});
    const std::string before = readText(path);
    const std::string advice = "begin anew with --overwrite";
    for (const auto& [option, value, difference] :
         {std::array{"--seed", "1", "its setting seed"},
          {"--size", "16x16", "its setting crop"},
          {"--set", "/materials/grey/color=0.7", "another scene"},
          {"--set", "/lights/0/radiance=21", "another scene"}}) {
        const ProgramResult result = runProgram(render({"--film", path, option, value}));
        expectFailure(result, 3, difference);
        expectFailure(result, 3, advice);
    }
    EXPECT_TRUE(readText(path) == before);
    const std::string cutOff = folder_.write("cut", before.substr(0, before.size() - 9));
    expectFailure(runProgram(render({"--film", cutOff})), 3, advice);
}

TEST_F(FilmRetryTest, OverwriteBeginsAnew) {
    const std::string path = film("a", {"--spp", "64"});
    EXPECT_EQ(runProgram(render({"--film", path, "--spp", "32", "--overwrite"})).exitCode, 0);
    expectSameFilm(path, film("b", {"--spp", "32"}));
    EXPECT_EQ(
        runProgram(render({"--film", path, "--seed", "1", "--spp", "16", "--overwrite"})).exitCode,
        0);
    expectSameFilm(path, film("c", {"--spp", "16", "--seed", "1"}));
    expectFailure(runProgram(render({"--resume", path, "--overwrite"})), 2, "--film");
    expectFailure(runProgram(render({"--resume", path, "--film", path, "--overwrite"})), 2,
                  "leave out one");
}

// With --resume A --film B, a later try continues what is in B.
TEST_F(FilmRetryTest, AResumedFilmInAnotherFileIsContinuedThere) {
    const std::string a = film("a", {"--spp", "32"});
    const std::string b = folder_ / "b";
    const auto run = [&](const char* samples) {
        return runProgram(render({"--resume", a, "--film", b, "--spp", samples}));
    };
    EXPECT_EQ(run("64").exitCode, 0);
    EXPECT_EQ(run("48").exitCode, 0);
    EXPECT_EQ(samplesOf(b), 64u) << "not replaced by less";
    EXPECT_EQ(run("96").exitCode, 0);
    expectSameFilm(b, film("whole", {"--spp", "96"}));
    EXPECT_EQ(samplesOf(a), 32u);
    const std::string other = film("other", {"--samples", "32:64"});
    expectFailure(runProgram(render({"--resume", a, "--film", other})), 3,
                  "lacks samples of the film to resume: 0:32");
    EXPECT_EQ(samplesOf(other), 32u);
}

// A folder in the way stands for a full disk: only at the end is it known that nothing is written.
TEST_F(FilmRetryTest, WhatCannotBeWrittenIsKeptElsewhere) {
    const std::string spare = folder_ / "spare";
    fs::create_directory(spare);
    for (const bool isFilm : {true, false}) {
        const std::string path = folder_ / (isFilm ? "full/a.film" : "full/a.pfm");
        fs::create_directory(folder_ / "full");
        const std::string started = folder_ / "full/preview.png";
        bool isFull = false;
        ProgramOptions options;
        options.environment["TMPDIR"] = spare;
        options.whileRunning = [&](int pid, double) {
            if (isFull || !fs::exists(started))
                return;
            isFull = true;
            fs::remove(path);
            fs::create_directory(path);
            kill(pid, SIGTERM);
        };
        const ProgramResult result =
            runProgram(render({isFilm ? "--film" : "-o", path, "--spp", "1000000",
                               "--preview-every", "32", "--preview-file", started}),
                       options);
        expectFailure(result, 6, "is kept in '" + spare);
        const std::string kept = keptIn(result.errors);
        const std::string move = commandIn(result.errors);
        fs::remove_all(folder_ / "full");
        if (isFilm) {
            EXPECT_GE(samplesOf(kept), 32u);
            fs::create_directory(folder_ / "full");
            ASSERT_EQ(std::system(move.c_str()), 0) << move;
            const std::string samples = std::to_string(samplesOf(path));
            expectSameFilm(path, film("whole", {"--spp", samples}));
            fs::remove_all(folder_ / "full");
        } else {
            EXPECT_EQ(readText(kept).size(),
                      std::string("PF\n32 24\n-1.0\n").size() + 32 * 24 * 12);
        }
    }
}

// A failure of one output loses none of the others, and all failures are named.
TEST_F(FilmRetryTest, EachFailureIsNamed) {
    const std::string started = folder_ / "preview.png";
    const std::vector<std::string> blocked = {folder_ / "a.film", folder_ / "a.pfm",
                                              folder_ / "a.exr"};
    bool isFull = false;
    ProgramOptions options;
    options.whileRunning = [&](int pid, double) {
        if (isFull || !fs::exists(started))
            return;
        isFull = true;
        for (const std::string& path : blocked) {
            fs::remove(path);
            fs::create_directory(path);
        }
        kill(pid, SIGTERM);
    };
    options.environment["TMPDIR"] = folder_ / "none";
    const ProgramResult result =
        runProgram(render({"--film", blocked[0], "-o", blocked[1], "-o", blocked[2], "-o",
                           folder_ / "a.png", "--stats", folder_ / "a.json", "--spp", "1000000",
                           "--preview-every", "16", "--preview-file", started}),
                   options);
    for (const std::string& path : blocked)
        expectFailure(result, 6, "cannot write '" + path + "'");
    EXPECT_EQ(readText(folder_ / "a.png").substr(1, 3), "PNG");
    EXPECT_NE(readText(folder_ / "a.json").find("\"ended_by\": \"interrupt\""), std::string::npos);
}

} // namespace
} // namespace calotype::test
