// Data flows one way through host/, and no file of the shader library reaches outside its rules.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/paths.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = kProjectFolder;

std::vector<fs::path> filesBelow(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> linesOf(const fs::path& file) {
    std::vector<std::string> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// The first folder of each quoted include of a file.
std::set<std::string> includedFolders(const fs::path& file) {
    static const std::regex include(R"(^\s*#\s*include\s*"([a-z_]+)/)");
    std::set<std::string> folders;
    for (const std::string& line : linesOf(file))
        if (std::smatch match; std::regex_search(line, match, include))
            folders.insert(match[1]);
    return folders;
}

using FolderOrder = std::vector<std::string>;

/// Place of a folder in an order; the order's length where it has none.
size_t placeIn(const FolderOrder& order, const std::string& folder) {
    return static_cast<size_t>(std::find(order.begin(), order.end(), folder) - order.begin());
}

/// Expects that every file below `root` includes only its own folder and those to its left.
void expectOrder(const fs::path& root, const FolderOrder& order) {
    for (const fs::path& file : filesBelow(root)) {
        const std::string folder = *fs::relative(file, root).begin();
        const size_t place = placeIn(order, folder);
        ASSERT_LT(place, order.size()) << folder << " has no place in the order";
        for (const std::string& included : includedFolders(file)) {
            ASSERT_LT(placeIn(order, included), order.size()) << file << " includes " << included;
            EXPECT_LE(placeIn(order, included), place) << file << " includes " << included;
        }
    }
}

// The order of the design: a folder includes itself and what stands to its left.
TEST(FolderOrderTest, HostIncludesOnlyToTheLeft) {
    const FolderOrder order = {"base",   "math",      "shared",  "image",   "settings",  "scene",
                               "mesh",   "materials", "check",   "read",    "accel",     "pack",
                               "gpu",    "film",      "denoise", "kernels", "reference", "render",
                               "engine", "study",     "cli"};
    expectOrder(kRoot / "host", order);
    EXPECT_GT(filesBelow(kRoot / "host").size(), 50u);
}

TEST(FolderOrderTest, ShadersIncludeOnlyToTheLeft) {
    const FolderOrder order = {"shared", "core",  "config", "shapes", "bsdf", "buffers",
                               "accel",  "scene", "lights", "film",   "path", "kernels"};
    expectOrder(kRoot / "shaders", order);
    for (const std::string& folder : order)
        EXPECT_FALSE(filesBelow(kRoot / "shaders" / folder).empty()) << folder;
}

// The reference judges what stands between the scene and it, so it must share nothing of that.
TEST(FolderOrderTest, ReferenceUsesTheSceneOnly) {
    const std::set<std::string> allowed = {"base",     "math",  "image",
                                           "settings", "scene", "reference"};
    size_t files = 0;
    for (const fs::path& file : filesBelow(kRoot / "host/reference")) {
        ++files;
        for (const std::string& included : includedFolders(file))
            EXPECT_TRUE(allowed.contains(included)) << file << " includes " << included;
    }
    EXPECT_GT(files, 0u);
}

// Else an include could pass by the two tests above.
TEST(FolderOrderTest, IncludesStartAtARootAndAreQuoted) {
    static const std::regex evasive(
        R"re(^\s*#\s*include\s*("\.|"[^"]*/\.\./|<(base|math|image|shared|settings)/))re"
        R"re(|^\s*#\s*include\s*<(scene|mesh|materials|check|read|accel|pack|gpu)/)re"
        R"re(|^\s*#\s*include\s*<(film|denoise|kernels|reference|render|engine|study|cli)/)re");
    for (const char* folder : {"host", "shaders", "tests"})
        for (const fs::path& file : filesBelow(kRoot / folder))
            for (const std::string& line : linesOf(file))
                EXPECT_FALSE(std::regex_search(line, evasive)) << file << ": " << line;
}

// Shader library code is pure, so that a test kernel can call the very function that the renderer
// calls. Each of these has its folders: specialization constants, reads of the packed scene, and
// the kernels' own inputs, outputs and global variables (declarations that start a line).
TEST(FolderOrderTest, ShaderLibraryIsPure) {
    struct Impurity {
        std::regex text;
        std::set<std::string> folders;
    };
    const std::vector<Impurity> impurities = {
        {std::regex(R"(\blayout\s*\()"), {"config", "buffers", "kernels"}},
        {std::regex(R"(\bconstant_id\b)"), {"config", "kernels"}},
        {std::regex(R"(\btexelFetch\b)"), {"buffers"}},
        {std::regex(R"(\bgl_[A-Z]|\bimage(Load|Store)\b|\batomic[A-Z]|^\s*shared\b)"), {"kernels"}},
        {std::regex(R"(^(?!(const|CALOTYPE_CONSTANT|using)\b)(\w+\s+)+\w+(\[[^\]]*\])*\s*[=;,])"),
         {"kernels"}},
    };
    for (const fs::path& file : filesBelow(kRoot / "shaders")) {
        const std::string folder = *fs::relative(file, kRoot / "shaders").begin();
        for (const std::string& line : linesOf(file))
            for (const Impurity& impurity : impurities)
                EXPECT_TRUE(impurity.folders.contains(folder) ||
                            !std::regex_search(line, impurity.text))
                    << file << ": " << line;
    }
}

// A file has one idea: a longer file has several.
TEST(FolderOrderTest, FilesHaveAtMostFourHundredLines) {
    const std::set<std::string> extensions = {".cpp", ".h", ".glsl", ".comp", ".py"};
    size_t files = 0;
    for (const char* folder : {"host", "shaders", "tests"})
        for (const fs::path& file : filesBelow(kRoot / folder))
            if (extensions.contains(file.extension())) {
                ++files;
                EXPECT_LE(linesOf(file).size(), 400u) << file;
            }
    EXPECT_GT(files, 500u);
}

TEST(FolderOrderTest, KernelsAreShort) {
    for (const fs::path& file : filesBelow(kRoot / "shaders/kernels"))
        EXPECT_TRUE(file.extension() != ".comp" || linesOf(file).size() <= 60) << file;
}

TEST(FolderOrderTest, LinesFitIntoAHundredColumns) {
    for (const char* folder : {"host", "shaders", "tests"})
        for (const fs::path& file : filesBelow(kRoot / folder)) {
            const std::string extension = file.extension();
            if (extension != ".cpp" && extension != ".h" && extension != ".glsl" &&
                extension != ".comp")
                continue;
            for (const std::string& line : linesOf(file)) {
                const auto continuationBytes = std::count_if(
                    line.begin(), line.end(), [](char c) { return (c & 0xC0) == 0x80; });
                EXPECT_LE(static_cast<long>(line.size()) - continuationBytes, 100)
                    << file << ": " << line;
            }
        }
}

// What the program needs from the system, as the dynamic linker sees it.
TEST(FolderOrderTest, ProgramLinksNoWindowSystem) {
    FILE* pipe = popen(("readelf -d '" + std::string(kProgram) + "'").c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::string libraries;
    char buffer[4096];
    while (const size_t n = fread(buffer, 1, sizeof buffer, pipe))
        libraries.append(buffer, n);
    ASSERT_EQ(pclose(pipe), 0);
    EXPECT_NE(libraries.find("libc.so"), std::string::npos);
    for (const char* library : {"libX11", "libxcb", "libwayland", "libglfw", "libSDL"})
        EXPECT_EQ(libraries.find(library), std::string::npos) << library;
}

} // namespace
} // namespace calotype::test
