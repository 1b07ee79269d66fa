// What ends a render: an error, a time, or a number of samples.
#include <bit>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/cli_test.h"

namespace calotype::test {
namespace {

class GoalTest : public CliTest {
protected:
    ProgramResult render(const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"render",          scene_,    "-o",
                                              folder_ / "a.png", "--stats", stats_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runProgram(arguments);
    }

    nlohmann::json statistics() const { return nlohmann::json::parse(readText(stats_)); }

    std::string stats_ = folder_ / "stats.json";
};

TEST_F(GoalTest, TargetErrorEndsAtALook) {
    const ProgramResult result = render({"--target-error", "0.05"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto json = statistics();
    EXPECT_EQ(json["ended_by"], "target-error");
    EXPECT_LE(json["error"]["bound"], 0.05);
    EXPECT_LT(json["error"]["relative"], json["error"]["bound"]);
    EXPECT_EQ(json["error"]["trusted"], true);
    EXPECT_EQ(json["error"]["replicas"], 8);
    const auto spp = json["spp"].get<uint32_t>();
    EXPECT_GT(spp, 4u) << "the scene's number of samples is no limit";
    // Looks are 8, 9, ... 15 times 16, 32, 64, ...
    const uint32_t step = std::bit_floor(spp) / 8;
    EXPECT_EQ(spp % step, 0u) << spp;
    EXPECT_NE(result.errors.find(std::to_string(spp) + " samples per pixel"), std::string::npos);
    EXPECT_NE(result.errors.find("error "), std::string::npos);
    ASSERT_GT(spp, 128u);
    const uint32_t before = spp - (std::has_single_bit(spp) ? step / 2 : step);
    ASSERT_EQ(render({"--spp", std::to_string(before)}).exitCode, 0);
    EXPECT_GT(statistics()["error"]["bound"], 0.05) << "a look earlier it was not there";
}

TEST_F(GoalTest, TheFirstGoalThatIsReachedEnds) {
    ASSERT_EQ(render({"--target-error", "0.5", "--spp", "4096", "--time", "60s"}).exitCode, 0);
    EXPECT_EQ(statistics()["ended_by"], "target-error");
    const ProgramResult samples =
        render({"--target-error", "0.0001", "--spp", "64", "--time", "60s"});
    ASSERT_EQ(samples.exitCode, 0) << samples.errors;
    EXPECT_EQ(statistics()["ended_by"], "samples");
    EXPECT_EQ(statistics()["spp"], 64);
    EXPECT_NE(samples.errors.find("was not reached: it is"), std::string::npos) << samples.errors;
    const ProgramResult time = render({"--target-error", "0.0001", "--time", "1.5s"});
    ASSERT_EQ(time.exitCode, 0) << time.errors;
    EXPECT_EQ(statistics()["ended_by"], "time");
}

TEST_F(GoalTest, TimeCountsFromTheStart) {
    for (const char* time : {"1s", "0.02m"}) {
        const ProgramResult result = render({"--time", time});
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_GT(result.seconds, 0.95);
        EXPECT_LT(result.seconds, 3.5);
        EXPECT_GT(statistics()["spp"], 4);
        EXPECT_EQ(result.errors.find(" of "), std::string::npos) << result.errors;
    }
    // Too short for anything but the first sample.
    ASSERT_EQ(render({"--time", "0.001s"}).exitCode, 0);
    EXPECT_GE(statistics()["spp"], 1);
}

TEST_F(GoalTest, AScenesFirefliesAreDoubted) {
    const std::string scene = folder_.write("caustic.json", R"({
      "camera": { "position": [0, 2, 5], "target": [0, 0.5, 0], "fov": 40 },
      "film": { "width": 64, "height": 64 },
      "render": { "max_bounces": 8 },
      "materials": { "wall": { "type": "diffuse", "color": 0.7 },
                     "glass": { "type": "dielectric", "ior": 1.5 } },
      "shapes": [
        { "type": "quad", "vertices": [[-4,0,4],[4,0,4],[4,0,-4],[-4,0,-4]], "material": "wall" },
        { "type": "sphere", "center": [0, 1, 0], "radius": 0.6, "material": "glass" },
        { "type": "sphere", "center": [1, 0.4, 1], "radius": 0.4, "material": "glass" }
      ],
      "lights": [ { "type": "disk", "center": [1, 5, 1], "normal": [0, -1, 0], "radius": 0.05,
                    "radiance": 4000 } ]
    })");
    for (const char* sampler : {"independent", "sobol"})
        for (const char* seed : {"0", "1", "2", "3"}) {
            // An estimate that is not to be trusted ends no render, however small it is.
            const ProgramResult result = runProgram(
                {"render", scene, "-o", folder_ / "a.png", "--quiet", "--sampler", sampler,
                 "--seed", seed, "--stats", stats_, "--target-error", "0.5", "--spp", "256"});
            ASSERT_EQ(result.exitCode, 0) << result.errors;
            EXPECT_EQ(statistics()["ended_by"], "samples");
            EXPECT_LT(statistics()["error"]["bound"], 0.5);
            EXPECT_EQ(statistics()["error"]["trusted"], false);
            EXPECT_NE(result.errors.find("warning: the error of"), std::string::npos);
            EXPECT_NE(result.errors.find("not to be trusted"), std::string::npos) << result.errors;
        }
}

// A picture without a lit sample is not known to be black.
TEST_F(GoalTest, BlackPicturesAreNotKnownToBeExact) {
    const std::vector<std::string> away = {"--set", "/camera/position=[0, 9, 0]", "--set",
                                           "/camera/target=[0, 19, 1]"};
    std::vector<std::string> arguments = {"--target-error", "0.1", "--spp", "256"};
    arguments.insert(arguments.end(), away.begin(), away.end());
    const ProgramResult result = render(arguments);
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(statistics()["ended_by"], "samples");
    EXPECT_TRUE(statistics()["error"].is_null());
    EXPECT_NE(result.errors.find("was not reached"), std::string::npos) << result.errors;
    const ProgramResult dark = render({"--target-error", "0.1", "--set", "/lights=[]"});
    EXPECT_EQ(dark.exitCode, 2);
    EXPECT_NE(dark.errors.find("the scene has no light"), std::string::npos) << dark.errors;
}

// The switches of transport decide on the samples, and statistics and films say so.
TEST_F(GoalTest, SwitchesChangeThePictureAndAreRecorded) {
    const auto picture = [&](const std::vector<std::string>& switches) {
        std::vector<std::string> arguments = {"render",
                                              scene_,
                                              "-q",
                                              "-o",
                                              folder_ / "a.pfm",
                                              "--stats",
                                              stats_,
                                              "--film",
                                              folder_ / "a.film",
                                              "--spp",
                                              "16",
                                              "--max-bounces",
                                              "8"};
        arguments.insert(arguments.end(), switches.begin(), switches.end());
        const ProgramResult result = runProgram(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        std::filesystem::remove(folder_ / "b.film");
        std::filesystem::rename(folder_ / "a.film", folder_ / "b.film");
        return readText(folder_ / "a.pfm");
    };
    const std::string usual = picture({});
    const nlohmann::json defaults = statistics();
    struct Switch {
        std::vector<std::string> arguments;
        const char* name;
        nlohmann::json usual;
        nlohmann::json value;
    };
    const Switch switches[] = {
        {{"--mis", "off"}, "mis", true, false},
        {{"--roulette", "off"}, "roulette", true, false},
        {{"--clamp-indirect", "0.015625"}, "clamp_indirect", nullptr, 0.015625},
        {{"--sampler", "independent"}, "sampler", "sobol", "independent"},
        {{"--light-choice", "uniform"}, "light_choice", "power", "uniform"},
        {{"--texture-filter", "nearest"}, "texture_filter", "scene", "nearest"},
        {{"--bvh", "median"}, "bvh", "sah", "median"},
    };
    for (const Switch& one : switches) {
        SCOPED_TRACE(one.name);
        EXPECT_EQ(defaults[one.name], one.usual);
        const bool isSame = picture(one.arguments) == usual;
        EXPECT_EQ(statistics()[one.name], one.value);
        const ProgramResult info = runProgram({"info", folder_ / "b.film", "--json"});
        EXPECT_EQ(nlohmann::json::parse(info.output)["settings"][one.name], one.value);
        // One light, no texture, and trees that find the same hits.
        const std::string name = one.name;
        EXPECT_EQ(isSame, name == "light_choice" || name == "texture_filter" || name == "bvh");
    }
}

// Bit for bit the same whatever the threads and previews; and what the reference tracer makes of
// it.
TEST_F(GoalTest, AdaptiveIsReproducible) {
    const auto picture = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"render",          scene_,    "-q",   "-o",
                                              folder_ / "a.pfm", "--stats", stats_, "--adaptive",
                                              "--spp",           "256"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = runProgram(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_NEAR(statistics()["spp"].get<double>(), 256.0, 8.0);
        EXPECT_EQ(statistics()["adaptive"], true);
        return readText(folder_ / "a.pfm");
    };
    const std::string one = picture({"--threads", "1"});
    EXPECT_TRUE(picture({"--preview-every", "7", "--preview-file", folder_ / "p.png"}) == one);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "p.png"));
    EXPECT_FALSE(picture({"--seed", "4"}) == one);
    picture({"--device", "reference"});
    std::filesystem::rename(folder_ / "a.pfm", folder_ / "reference.pfm");
    picture({});
    const ProgramResult compared = runProgram(
        {"compare", folder_ / "a.pfm", folder_ / "reference.pfm", "--max-relmse", "1e-4"});
    EXPECT_EQ(compared.exitCode, 0) << compared.output;
}

TEST_F(GoalTest, MistakesAreNamed) {
    expectFailure(render({"--adaptive", "--samples", "0:64"}), 2, "--samples");
    expectFailure(render({"--adaptive", "--film", folder_ / "x.film"}), 2, "--adaptive");
    for (const char* target : {"0", "-0.1", "1", "2%", "nan", "x"})
        expectFailure(render({"--target-error", target}), 2, "such as 0.02");
    for (const char* time : {"0s", "-5s", "soon", "5d", "inf", "nan", "1e30h"})
        expectFailure(render({"--time", time}), 2, "30s, 5m or 2h");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
}

TEST_F(GoalTest, StatsOfFewSamplesHaveNoError) {
    ASSERT_EQ(render({"--spp", "16"}).exitCode, 0);
    EXPECT_TRUE(statistics()["error"].is_null());
}

} // namespace
} // namespace calotype::test
