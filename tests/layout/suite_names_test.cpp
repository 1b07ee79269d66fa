// Suites of tests are named one way.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "support/paths.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

TEST(SuiteNamesTest, EndInTest) {
    const std::regex suite(R"((?:^|\n)TEST(?:_F|_P)?\((\w+),)");
    size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(kProjectFolder) / "tests")) {
        if (entry.path().extension() != ".cpp")
            continue;
        std::ifstream file(entry.path());
        const std::string text(std::istreambuf_iterator<char>(file), {});
        for (auto match = std::sregex_iterator(text.begin(), text.end(), suite);
             match != std::sregex_iterator(); ++match, ++count)
            EXPECT_TRUE((*match)[1].str().ends_with("Test"))
                << entry.path() << ": suite " << (*match)[1];
    }
    EXPECT_GT(count, 500u);
}

} // namespace
} // namespace calotype::test
