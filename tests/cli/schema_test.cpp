// `calotype schema`.
#include <fstream>
#include <iterator>

#include "cli/cli_test.h"
#include "support/paths.h"

namespace calotype::test {
namespace {

TEST(SchemaTest, PrintsTheFileThatComesWithTheScenes) {
    std::ifstream file(std::string(kProjectFolder) + "/scenes/scene.schema.json");
    const std::string expected{std::istreambuf_iterator<char>(file), {}};
    const ProgramResult result = runProgram({"schema"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output, expected);
}

} // namespace
} // namespace calotype::test
