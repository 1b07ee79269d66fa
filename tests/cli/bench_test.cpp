// `calotype bench`.
#include <fstream>

#include <nlohmann/json.hpp>

#include "cli/cli_test.h"

namespace calotype::test {
namespace {

using BenchTest = CliTest;

TEST_F(BenchTest, MeasuresEachSceneAndWritesALineOfJson) {
    const std::string file = folder_ / "bench.json";
    const ProgramResult result =
        runProgram({"bench", scene_, scene_, "--repeats", "3", "--spp", "1", "--sampler",
                    "independent", "--json", file, "--threads", "1"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    for (const char* text :
         {"paths/s", "rays/s", "first sample", "primary rays", "shadow rays", "memory"})
        EXPECT_NE(result.output.find(text), std::string::npos) << text << "\n" << result.output;
    std::ifstream lines(file);
    std::string line;
    size_t count = 0;
    for (; std::getline(lines, line); ++count) {
        const auto json = nlohmann::json::parse(line);
        EXPECT_EQ(json.at("scene"), scene_);
        EXPECT_EQ(json.at("primitives"), 4);
        EXPECT_EQ(json.at("repeats"), 3);
        EXPECT_EQ(json.at("spp"), 1);
        EXPECT_EQ(json.at("sampler"), "independent");
        EXPECT_EQ(json.at("size"), nlohmann::json({32, 24}));
        EXPECT_EQ(json.at("threads"), 1);
        for (const auto& rate : {json.at("paths_per_second"), json.at("rays_per_second"),
                                 json.at("traversal_rays_per_second").at("primary")}) {
            EXPECT_GT(rate.at("min"), 0.0);
            EXPECT_LE(rate.at("min"), rate.at("median"));
            EXPECT_LE(rate.at("median"), rate.at("max"));
        }
        const auto& seconds = json.at("seconds");
        double sum = 0.0;
        for (const char* stage : {"load", "build", "upload", "compile", "first_pass"})
            sum += seconds.at(stage).get<double>();
        EXPECT_NEAR(seconds.at("first_sample").get<double>(), sum, 1e-9);
    }
    EXPECT_EQ(count, 2u);
}

TEST_F(BenchTest, MistakesAreUsageErrors) {
    EXPECT_EQ(runProgram({"bench", scene_, "--repeats", "0"}).exitCode, 2);
    EXPECT_EQ(runProgram({"bench", scene_, "--spp", "0"}).exitCode, 2);
    EXPECT_EQ(runProgram({"bench", folder_ / "none.json"}).exitCode, 3);
    EXPECT_EQ(runProgram({"bench", scene_, "--json", folder_ / "none/bench.json"}).exitCode, 6);
}

} // namespace
} // namespace calotype::test
