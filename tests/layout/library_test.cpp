// What lies below the command line is a library: it shows nothing, ends nothing, and leaves the
// process as it is.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/paths.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

const fs::path kHost = fs::path(kProjectFolder) / "host";

std::vector<fs::path> filesOf(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// Calls `look` with each line that matches `pattern`, without its comment.
template <typename Look>
void findLines(const fs::path& file, const std::regex& pattern, const Look& look) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const std::string code = line.substr(0, line.find("//"));
        if (std::smatch match; std::regex_search(code, match, pattern))
            look(line, match);
    }
}

// The one exception is base/check.h, which ends the program for a mistake of its own code.
TEST(LibraryTest, NeverPrintsExitsOrTouchesTheProcess) {
    const std::regex forbidden(
        R"(\b(printf|fprintf|puts|fputs|putchar|perror|exit|_exit|quick_exit|abort|terminate)\s*\()"
        R"(|\b(setenv|putenv|unsetenv|signal|sigaction|raise|chdir|fchdir|umask|setlocale)\s*\()"
        R"(|\b(cout|cerr|clog)\b|\bcurrent_path\s*\(\s*[^)\s])");
    size_t files = 0;
    for (const fs::path& file : filesOf(kHost)) {
        const fs::path place = fs::relative(file, kHost);
        if (*place.begin() == "cli" || place == "base/check.h")
            continue;
        ++files;
        findLines(file, forbidden, [&](const std::string& line, const std::smatch&) {
            ADD_FAILURE() << file << ": " << line;
        });
    }
    EXPECT_GT(files, 100u);
}

// The command line uses the engine, not what the engine is made of; films and studies are of
// settings, whatever the scene.
TEST(LibraryTest, HasNoShortcuts) {
    const std::map<std::string, std::set<std::string>> forbidden = {
        {"cli", {"accel", "pack", "gpu", "kernels", "reference"}},
        {"film", {"scene"}},
        {"study", {"scene", "accel", "pack", "gpu"}}};
    const std::regex include(R"(^\s*#\s*include\s*"([a-z_]+)/)");
    for (const auto& [folder, others] : forbidden)
        for (const fs::path& file : filesOf(kHost / folder))
            findLines(file, include, [&](const std::string& line, const std::smatch& match) {
                EXPECT_FALSE(others.contains(match[1])) << file << ": " << line;
            });
}

// So that a scene's hash and its list of files are of all that is read. The text of a scene file is
// hashed after --set.
TEST(LibraryTest, ReadersReadFilesInOnePlace) {
    for (const fs::path& file : filesOf(kHost / "read")) {
        const fs::path place = fs::relative(file, kHost);
        if (place != "read/read_context.h" && place != "read/json/scene.cpp")
            findLines(file, std::regex(R"(\b(readFile|fopen|ifstream)\b)"),
                      [&](const std::string& line, const std::smatch&) {
                          ADD_FAILURE() << file << ": " << line;
                      });
    }
}

// Environment variables are the command line's, but for where compiled kernels are kept.
TEST(LibraryTest, ReadsNoVariableButTheCacheFolder) {
    for (const fs::path& file : filesOf(kHost)) {
        const fs::path place = fs::relative(file, kHost);
        if (*place.begin() != "cli" && place != "gpu/pipeline_cache.cpp")
            findLines(file, std::regex(R"(\bgetenv\b)"),
                      [&](const std::string& line, const std::smatch&) {
                          ADD_FAILURE() << file << ": " << line;
                      });
    }
}

} // namespace
} // namespace calotype::test
