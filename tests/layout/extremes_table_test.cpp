// The table of the extremes and their tests name each other: no row without a test, no test without
// a row.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/paths.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

const fs::path kTests = fs::path(kProjectFolder) / "tests";

std::string textOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// "Suite.Case" of every test in a folder.
std::vector<std::string> testsIn(const std::string& folder) {
    static const std::regex macro(R"(TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\))");
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(kTests / folder)) {
        const std::string text = entry.path().extension() == ".cpp" ? textOf(entry.path()) : "";
        for (std::sregex_iterator match(text.begin(), text.end(), macro), end; match != end;
             ++match)
            names.push_back((*match)[1].str() + "." + (*match)[2].str());
    }
    return names;
}

/// The patterns of the last column, as ctest -R takes them.
std::vector<std::string> rowPatterns() {
    static const std::regex row(R"(\| `([^`|]+)` \|\n)");
    const std::string table = textOf(kTests / "extremes" / "README.md");
    std::vector<std::string> patterns;
    for (std::sregex_iterator match(table.begin(), table.end(), row), end; match != end; ++match)
        patterns.push_back((*match)[1]);
    return patterns;
}

bool isNamedBy(const std::string& test, const std::string& pattern) {
    return std::regex_search(test, std::regex(pattern));
}

TEST(ExtremesTableTest, EveryRowNamesATest) {
    std::vector<std::string> tests = testsIn("extremes");
    std::ranges::copy(testsIn("gpu"), std::back_inserter(tests));
    EXPECT_GT(rowPatterns().size(), 40u);
    for (const std::string& pattern : rowPatterns())
        EXPECT_TRUE(std::ranges::any_of(tests, [&](const auto& test) {
            return isNamedBy(test, pattern);
        })) << pattern;
}

TEST(ExtremesTableTest, EveryTestHasARow) {
    const std::vector<std::string> patterns = rowPatterns();
    EXPECT_GT(testsIn("extremes").size(), 40u);
    for (const std::string& test : testsIn("extremes"))
        EXPECT_TRUE(std::ranges::any_of(patterns, [&](const auto& pattern) {
            return isNamedBy(test, pattern);
        })) << test;
}

} // namespace
} // namespace calotype::test
