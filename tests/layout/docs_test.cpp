// The pages and the code agree: links lead to files and sections that exist, paths that a page
// names exist, and comments cite sections of docs/models.md that exist.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/paths.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = kProjectFolder;

std::string textOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// All matches of the first group.
std::vector<std::string> matchesIn(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        found.push_back((*match)[1]);
    return found;
}

std::vector<fs::path> filesBelow(const fs::path& folder, const std::set<std::string>& extensions) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && extensions.contains(entry.path().extension().string()))
            files.push_back(entry.path());
    return files;
}

std::vector<fs::path> pages() {
    std::vector<fs::path> files = {kRoot / "README.md", kRoot / "CONTRIBUTING.md"};
    for (const char* folder : {"docs", "tests"})
        for (const fs::path& file : filesBelow(kRoot / folder, {".md"}))
            files.push_back(file);
    return files;
}

/// Code blocks are not text: what looks like a link there is none.
std::string withoutCodeBlocks(const std::string& page) {
    return std::regex_replace(page, std::regex("```[^`]*```"), "");
}

/// The anchor that GitHub gives a heading.
std::string anchorOf(const std::string& heading) {
    std::string anchor;
    for (const char c : heading)
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ')
            anchor += '-';
    return anchor;
}

std::vector<std::string> headingsOf(const fs::path& page) {
    static const std::regex heading("(?:^|\n)#+ ([^\n]+)");
    return matchesIn(withoutCodeBlocks(textOf(page)), heading);
}

bool hasAnchor(const fs::path& page, const std::string& anchor) {
    return std::ranges::any_of(
        headingsOf(page), [&](const std::string& heading) { return anchorOf(heading) == anchor; });
}

TEST(DocsTest, LinksLeadSomewhere) {
    static const std::regex link(R"(\]\(([^)\s]+)\))");
    size_t links = 0;
    for (const fs::path& page : pages())
        for (const std::string& target : matchesIn(withoutCodeBlocks(textOf(page)), link)) {
            if (target.find("://") != std::string::npos)
                continue;
            ++links;
            const size_t hash = std::min(target.find('#'), target.size());
            const std::string name = target.substr(0, hash);
            const fs::path file = name.empty() ? page : page.parent_path() / name;
            const bool leadsSomewhere =
                fs::exists(file) &&
                (hash == target.size() || hasAnchor(file, target.substr(hash + 1)));
            EXPECT_TRUE(leadsSomewhere) << page << " links to " << target;
        }
    EXPECT_GT(links, 100u);
}

TEST(DocsTest, PathsThatPagesNameExist) {
    static const std::regex path(
        R"re(`((?:host|shaders|scenes|docs|assets|cmake|examples|tests)/[A-Za-z0-9_./-]*)`)re");
    size_t paths = 0;
    for (const fs::path& page : pages())
        for (const std::string& name : matchesIn(withoutCodeBlocks(textOf(page)), path)) {
            ++paths;
            EXPECT_TRUE(fs::exists(kRoot / name)) << page << " names " << name;
        }
    EXPECT_GT(paths, 50u);
}

TEST(DocsTest, CommentsCiteSectionsOfModels) {
    static const std::regex lineBreak(R"(\s*\n\s*//[/<]*\s*)");
    static const std::regex citation(R"re(docs/models\.md, "([^"]+)")re");
    const std::vector<std::string> headings = headingsOf(kRoot / "docs/models.md");
    const std::set<std::string> sections(headings.begin(), headings.end());
    size_t citations = 0;
    for (const char* folder : {"host", "shaders", "tests"})
        for (const fs::path& file : filesBelow(kRoot / folder, {".h", ".cpp", ".glsl", ".comp"})) {
            const std::string text = textOf(file);
            if (text.find("docs/models.md") == std::string::npos)
                continue; // quicker than the search below
            for (const std::string& section :
                 matchesIn(std::regex_replace(text, lineBreak, " "), citation)) {
                ++citations;
                EXPECT_TRUE(sections.contains(section)) << file << " cites \"" << section << '"';
            }
        }
    EXPECT_GT(citations, 0u);
}

} // namespace
} // namespace calotype::test
