// Films in files: parts of a render in any order are the render, bit for bit, and what does not go
// together is refused. Signals and kills: film_interrupt_test.cpp.
#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/film_cli_test.h"

namespace calotype::test {
namespace {

TEST_F(FilmTest, RangesInAnyOrderAreTheWholeBitForBit) {
    for (const char* sampler : {"independent", "sobol"}) {
        SCOPED_TRACE(sampler);
        const auto filmOf = [&](const std::string& name, const char* option, const char* value) {
            return film(sampler + name, {option, value, "--sampler", sampler});
        };
        const std::string whole = filmOf("whole", "--spp", "192");
        const std::vector<std::string> parts = {
            filmOf("a", "--samples", "0:16"), filmOf("b", "--samples", "16:112"),
            filmOf("c", "--samples", "112:128"), filmOf("d", "--samples", "128:192")};
        const std::string merged = folder_ / "merged.film";
        for (const std::array<size_t, 4>& order :
             {std::array<size_t, 4>{0, 1, 2, 3}, {3, 2, 1, 0}, {1, 3, 0, 2}}) {
            std::vector<std::string> arguments = {"merge"};
            for (const size_t part : order)
                arguments.push_back(parts[part]);
            arguments.insert(arguments.end(), {"-o", merged});
            const ProgramResult result = runProgram(arguments);
            ASSERT_EQ(result.exitCode, 0) << result.errors;
            expectSameFilm(merged, whole);
        }
        // Joins of joins.
        EXPECT_EQ(runProgram({"merge", parts[3], parts[0], "-o", folder_ / "m1"}).exitCode, 0);
        EXPECT_EQ(runProgram({"merge", parts[1], parts[2], "-o", folder_ / "m2"}).exitCode, 0);
        EXPECT_EQ(runProgram({"merge", folder_ / "m1", folder_ / "m2", "-o", merged}).exitCode, 0);
        expectSameFilm(merged, whole);
    }
}

TEST_F(FilmTest, ResumingGoesOnToTheSameFilm) {
    const std::string whole = film("whole", {"--spp", "96"});
    const std::string part = film("part", {"--samples", "32:64"});
    ProgramResult result =
        runProgram(render({"--resume", part, "--spp", "96", "-o", folder_ / "a.pfm"}));
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    expectSameFilm(part, whole);
    // To another file: the one that it came from stays.
    const std::string start = film("start", {"--spp", "16"});
    const std::string before = readText(start);
    result = runProgram(render({"--resume", start, "--film", folder_ / "on", "--spp", "96"}));
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    expectSameFilm(folder_ / "on", whole);
    EXPECT_TRUE(readText(start) == before);
    // The picture is that of one render, as is what merge makes of the film.
    EXPECT_EQ(runProgram(render({"--spp", "96", "-o", folder_ / "b.pfm"})).exitCode, 0);
    EXPECT_TRUE(readText(folder_ / "a.pfm") == readText(folder_ / "b.pfm"));
    EXPECT_EQ(runProgram({"merge", whole, "-o", folder_ / "c.pfm"}).exitCode, 0);
    EXPECT_TRUE(readText(folder_ / "c.pfm") == readText(folder_ / "b.pfm"));
}

// Samples that fill no block show in the picture, and are rendered anew when the film goes on.
TEST_F(FilmTest, KeepsWholeBlocksOnly) {
    const std::string part = film("part", {"--spp", "40", "-o", folder_ / "a.pfm"});
    EXPECT_EQ(readFilm(part).film.samplesPerPixel(), 32u);
    EXPECT_EQ(runProgram(render({"--spp", "40", "-o", folder_ / "b.pfm"})).exitCode, 0);
    EXPECT_TRUE(readText(folder_ / "a.pfm") == readText(folder_ / "b.pfm"));
    EXPECT_EQ(runProgram(render({"--resume", part, "--spp", "64"})).exitCode, 0);
    expectSameFilm(part, film("whole", {"--spp", "64"}));
}

TEST_F(FilmTest, AFullFilmIsLeftAsItIs) {
    const std::string whole = film("whole", {"--spp", "32"});
    const std::string before = readText(whole);
    const ProgramResult result =
        runProgram({"render", scene_, "--resume", whole, "--spp", "16", "-o", folder_ / "a.png"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.errors.find("32 of 32 samples"), std::string::npos) << result.errors;
    EXPECT_TRUE(readText(whole) == before);
}

TEST_F(FilmTest, InfoSaysWhatItHolds) {
    const std::string a = film("a", {"--samples", "0:32", "--seed", "5"});
    const std::string b = film("b", {"--samples", "64:80", "--seed", "5"});
    EXPECT_EQ(runProgram({"merge", a, b, "-o", folder_ / "both"}).exitCode, 0);
    const ProgramResult asJson = runProgram({"info", folder_ / "both", "--json"});
    ASSERT_EQ(asJson.exitCode, 0) << asJson.errors;
    const auto json = nlohmann::json::parse(asJson.output);
    EXPECT_EQ(json["spp"], 48);
    EXPECT_EQ(json["ranges"], (nlohmann::json{{0, 32}, {64, 80}}));
    EXPECT_EQ(json["missing"], (nlohmann::json{{32, 64}}));
    EXPECT_EQ(json["settings"]["seed"], 5);
    EXPECT_EQ(json["resolution"], (nlohmann::json{32, 24}));
    EXPECT_GT(json["error"]["relative"], 0.0);
    const std::string stats = folder_ / "stats.json";
    EXPECT_EQ(
        runProgram(render({"-o", folder_ / "a.png", "--stats", stats, "--seed", "9"})).exitCode, 0);
    const auto statistics = nlohmann::json::parse(readText(stats));
    EXPECT_EQ(json["scene_hash"], statistics["scene_hash"]);
    // One type for one fact.
    for (const auto& [name, value] : json["settings"].items())
        if (statistics.contains(name))
            EXPECT_STREQ(value.type_name(), statistics[name].type_name()) << name;
    const ProgramResult merged = runProgram({"merge", a, b, "-o", folder_ / "both", "--json"});
    EXPECT_EQ(nlohmann::json::parse(merged.output), json);
    ASSERT_EQ(json["devices"].size(), 1u);
    EXPECT_EQ(json["devices"][0].get<std::string>().find(statistics["device"].get<std::string>()),
              0u);
    const ProgramResult asText = runProgram({"info", folder_ / "both"});
    for (const char* word :
         {"48 per pixel: 0:32, 64:80", "missing        32:64", "32 x 24", "sampler", "sobol"})
        EXPECT_NE(asText.output.find(word), std::string::npos) << asText.output;
}

TEST_F(FilmTest, RefusesWhatDoesNotGoTogether) {
    const std::string a = film("a", {"--samples", "0:32"});
    const std::string overlapping = film("b", {"--samples", "16:48"});
    const std::string seed = film("c", {"--samples", "32:64", "--seed", "1"});
    const std::string sampler = film("d", {"--samples", "32:64", "--sampler", "independent"});
    const std::string other =
        film("e", {"--samples", "32:64", "--set", "/materials/grey/color=0.7"});
    const std::string size = film("f", {"--samples", "32:64", "--size", "16x16"});
    const std::string before = readText(a);
    const auto merge = [&](const std::string& b) {
        return runProgram({"merge", a, b, "-o", folder_ / "out"});
    };
    expectFailure(merge(overlapping), 3, "samples 16:32 are in a film before it too");
    expectFailure(merge(a), 3, "samples 0:32");
    expectFailure(merge(seed), 3, "its setting seed is 1, not 0");
    expectFailure(merge(sampler), 3, "its setting sampler is independent, not sobol");
    expectFailure(merge(other), 3, "another scene");
    expectFailure(merge(size), 3, "its setting crop");
    expectFailure(merge(scene_), 3, "no film");
    expectFailure(merge(folder_ / "none"), 3, "No such file");
    const std::string cutOff = folder_.write("cut", before.substr(0, before.size() - 9));
    expectFailure(merge(cutOff), 3, "damaged");
    EXPECT_EQ(std::ranges::count(folder_.names(), "out"), 0);
    const auto resume = [&](const std::string& film, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = render(more);
        arguments.insert(arguments.end(), {"--resume", film});
        return runProgram(arguments);
    };
    expectFailure(resume(a, {"--seed", "1"}), 3, "its setting seed");
    expectFailure(resume(a, {"--max-bounces", "3"}), 3, "its setting max_bounces is 2, not 3");
    expectFailure(resume(a, {"--set", "/materials/grey/color=0.7"}), 3, "another scene");
    expectFailure(resume(cutOff, {}), 3, "damaged");
    expectFailure(resume(folder_ / "none", {}), 3, "No such file");
    EXPECT_TRUE(readText(a) == before);
    // What decides on no sample may differ.
    EXPECT_EQ(resume(a, {"--set", "/render/spp=48"}).exitCode, 0);
    EXPECT_EQ(readFilm(a).film.samplesPerPixel(), 48u);
}

TEST_F(FilmTest, MistakesAreNamed) {
    const auto run = [&](const std::vector<std::string>& more) { return runProgram(render(more)); };
    const std::string film = folder_ / "x.film";
    expectFailure(run({}), 2, "--film");
    for (const char* range : {"0:17", "8:16", "16:16", "32:16", "16", "a:b", "0:67108880"})
        expectFailure(run({"--film", film, "--samples", range}), 2, "multiples of 16");
    expectFailure(run({"--film", film, "--samples", "0:16", "--spp", "16"}), 2, "--spp");
    expectFailure(run({"--film", folder_ / "x.png"}), 2, "extension of a picture");
    expectFailure(run({"--film", scene_}), 2, "is no film");
    expectFailure(run({"-o", folder_ / "a.png", "--checkpoint", "5s"}), 2, "--film");
    expectFailure(run({"--film", film, "--checkpoint", "soon"}), 2, "30s, 5m or 2h");
    expectFailure(run({"--film", film, "--preview-every", "1"}), 2, "--preview-file");
    expectFailure(run({"--film", folder_ / "no/such/x.film"}), 6, "folder");
    expectFailure(runProgram({"merge", film}), 2, "--output");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
}

// What is read is not written over by another output, and pipes are no films.
TEST_F(FilmTest, TheResumedFilmIsNoOutput) {
    const std::string path = film("a", {"--spp", "16"});
    const std::string before = readText(path);
    const std::string other = folder_ / "b";
    expectFailure(runProgram(render({"--resume", path, "--film", other, "--stats", path})), 2,
                  "is read by this command");
    expectFailure(runProgram(render({"--resume", path, "--film", "/dev/null"})), 2, "is no film");
    EXPECT_TRUE(readText(path) == before);
}

// mktemp makes such files: they are replaced at the start, so that a kill leaves a film.
TEST_F(FilmTest, AnEmptyFileBecomesAFilmAtOnce) {
    const std::string path = folder_.write("x.film", "");
    ProgramOptions options;
    options.whileRunning = [&](int pid, double) {
        if (isFilm(path))
            kill(pid, SIGKILL);
    };
    const ProgramResult result =
        runProgram(render({"--film", path, "--spp", "1000000", "--checkpoint", "1h"}), options);
    EXPECT_EQ(result.exitCode, 128 + SIGKILL);
    EXPECT_TRUE(readFilm(path).film.blocks().empty());
}

// Goals, crops and the reference tracer, with films.
TEST_F(FilmTest, GoesOnToAGoal) {
    const std::string path = film("a", {"--spp", "128"});
    const std::string stats = folder_ / "stats.json";
    ASSERT_EQ(
        runProgram(render({"--resume", path, "--target-error", "0.05", "--stats", stats})).exitCode,
        0);
    const auto json = nlohmann::json::parse(readText(stats));
    EXPECT_EQ(json["ended_by"], "target-error");
    EXPECT_LE(json["error"]["bound"], 0.05);
    const std::string spp = json["spp"].dump();
    expectSameFilm(path, film("b", {"--spp", spp}));
    ASSERT_EQ(runProgram(render({"--resume", path, "--time", "1.5s", "--stats", stats})).exitCode,
              0);
    EXPECT_GT(nlohmann::json::parse(readText(stats))["spp"], json["spp"]);
}

TEST_F(FilmTest, KeepsCropsAndTheReference) {
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--crop", "5,3,16,9"}, {"--device", "reference"}}) {
        const auto with = [&](std::vector<std::string> more) {
            more.insert(more.end(), options.begin(), options.end());
            return more;
        };
        const std::string name = options.back();
        const std::string whole = film(name + "w", with({"--spp", "48"}));
        const std::string a = film(name + "a", with({"--samples", "0:16"}));
        const std::string b = film(name + "b", with({"--samples", "16:48", "--seed", "0"}));
        ASSERT_EQ(runProgram({"merge", a, b, "-o", folder_ / "m.film", "-o", folder_ / "m.exr",
                              "--aov", "error"})
                      .exitCode,
                  0);
        expectSameFilm(folder_ / "m.film", whole);
        const std::string exr = folder_ / (name + ".exr");
        ASSERT_EQ(runProgram(render(with({"--spp", "48", "-o", exr, "--aov", "error", "--bvh",
                                          "sah"}))) // as films always have it
                      .exitCode,
                  0);
        EXPECT_TRUE(readText(folder_ / "m.exr") == readText(exr));
    }
    expectFailure(runProgram(render({"--resume", folder_ / "5,3,16,9w", "--spp", "64"})), 3,
                  "its setting crop");
}

// Films of programs that lacked some settings: their pictures have no place in a larger one.
TEST_F(FilmTest, MergesWhatSaysLess) {
    const std::string a = film("a.film", {"--samples", "0:16"});
    KeptFilm kept = readFilm(a);
    kept.label.settings = {{"seed", "0"}, {"mis", "no such value"}};
    const std::string less = folder_ / "less.film";
    writeFilm(less, kept.label, kept.film);
    for (const std::string& path : {a, less}) {
        const ProgramResult result =
            runProgram({"merge", path, "-o", path + ".pfm", "-o", path + ".exr"});
        EXPECT_EQ(result.exitCode, 0) << result.errors;
    }
    EXPECT_TRUE(readText(less + ".pfm") == readText(a + ".pfm"));
}

TEST_F(FilmTest, MergeChecksItsOutputs) {
    const std::string a = film("a.film", {"--samples", "0:16"});
    const auto merge = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"merge", a};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runProgram(arguments);
    };
    const std::string text = folder_.write("notes", "mine");
    expectFailure(merge({"-o", text}), 2, "is no film");
    expectFailure(merge({"-o", folder_ / "a.jpg"}), 2, "neither a film");
    expectFailure(merge({"-o", folder_ / "b.png", "-o", folder_ / "b.png"}), 2, "given twice");
    expectFailure(merge({"-o", folder_ / "b.png", "--aov", "error"}), 2, "add -o FILE.exr");
    for (const char* layer : {"normal", "meanAlbedo"})
        expectFailure(merge({"-o", folder_ / "b.exr", "--aov", layer}), 2, "merge writes error");
    expectFailure(merge({"-o", folder_ / "no/b.film"}), 6, "folder");
    expectFailure(runProgram(render({"--film", text})), 2, "is no film");
    for (const std::vector<std::string>& option :
         {std::vector<std::string>{"--set", "/film/width=3"},
          {"--bvh", "sah"},
          {"--threads", "2"},
          {"--up", "0,1,0"},
          {"--missing-textures", "warn"}}) {
        std::vector<std::string> words = {"info", a};
        words.insert(words.end(), option.begin(), option.end());
        expectFailure(runProgram(words), 2, "only --json can be given with a film");
    }
    EXPECT_EQ(readText(text), "mine");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.film", "notes", "scene.json"}));
}

// Gaps between the films' samples are named, and --require takes none.
TEST_F(FilmTest, MergeSaysWhichSamplesAreMissing) {
    const std::string a = film("a.film", {"--samples", "0:32"});
    const std::string b = film("b.film", {"--samples", "64:96"});
    const std::string both = folder_ / "both.film";
    const auto merge = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"merge", b, a, "-o", both};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runProgram(arguments);
    };
    const ProgramResult result = merge({});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output, "samples   64 per pixel: 0:32, 64:96\nmissing   32:64\n");
    std::filesystem::remove(both);
    expectFailure(merge({"--require", "0:96"}), 5, "--require 0:96: 32:64");
    expectFailure(merge({"--require", "16:128"}), 5, "--require 16:128: 32:64, 96:128");
    EXPECT_FALSE(std::filesystem::exists(both));
    expectFailure(merge({"--require", "0:100"}), 2, "multiples of 16");
    EXPECT_EQ(merge({"--require", "64:96"}).exitCode, 0);
    // The film of both is not replaced by less, unless by wish.
    const std::string before = readText(both);
    expectFailure(runProgram({"merge", a, "-o", both}), 3, "these films lack: 64:96");
    EXPECT_TRUE(readText(both) == before);
    EXPECT_EQ(runProgram({"merge", a, "-o", both, "--overwrite"}).exitCode, 0);
    expectSameFilm(both, a);
    EXPECT_EQ(runProgram({"merge", a, "-o", folder_ / "a.pfm", "--require", "0:32"}).output,
              "samples   32 per pixel: 0:32\n");
}

} // namespace
} // namespace calotype::test
