// The JSON that the program writes and docs/json.md name the same keys.
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "settings/settings_table.h"
#include "support/paths.h"
#include "support/test_denoiser.h"

namespace calotype::test {
namespace {

using Json = nlohmann::json;

/// What a section of docs/json.md says of a document.
struct Section {
    std::string heading;
    std::set<std::string> required; ///< keys of the tables' first columns
    std::set<std::string> known;    ///< these, and all keys that the text names
};

/// All words in backticks that can be keys; of a path such as `a[].b`, each part.
std::set<std::string> keysIn(const std::string& text) {
    static const std::regex quoted("`([a-z_.\\[\\]]+)`");
    static const std::regex word("[a-z_]+");
    std::set<std::string> keys;
    for (std::sregex_iterator quote(text.begin(), text.end(), quoted), end; quote != end; ++quote) {
        const std::string path = (*quote)[1];
        for (std::sregex_iterator key(path.begin(), path.end(), word); key != end; ++key)
            keys.insert(key->str());
    }
    return keys;
}

std::vector<Section> sectionsOfPage() {
    std::istringstream page(readText(std::string(kProjectFolder) + "/docs/json.md"));
    std::vector<Section> sections;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## "))
            sections.push_back({line.substr(3), {}, {}});
        if (sections.empty())
            continue;
        sections.back().known.merge(keysIn(line));
        if (line.starts_with("| `"))
            sections.back().required.merge(keysIn(line.substr(0, line.find(" | "))));
    }
    return sections;
}

/// The section whose heading begins so.
const Section& sectionOf(const std::vector<Section>& sections, const std::string& heading) {
    for (const Section& section : sections)
        if (section.heading.starts_with(heading))
            return section;
    throw std::runtime_error("docs/json.md has no section " + heading);
}

/// Keys at every depth.
std::set<std::string> keysOf(const Json& json) {
    std::set<std::string> keys;
    if (!json.is_structured()) // whose only item would be itself
        return keys;
    for (const auto& [key, value] : json.items()) {
        if (json.is_object())
            keys.insert(key);
        keys.merge(keysOf(value));
    }
    return keys;
}

Json outputOf(const std::vector<std::string>& arguments) {
    const ProgramResult result = runProgram(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    return Json::parse(result.output);
}

Json lastProgressLine(const std::string& errors) {
    std::string last;
    std::istringstream lines(errors);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with('{'))
            last = line;
    return Json::parse(last);
}

/// A document for each section, by the beginning of its heading.
std::map<std::string, Json> writeDocuments() {
    const TestFolder folder;
    const std::string scene = folder.write("scene.json", kSmallScene);
    const std::string stats = folder / "stats.json";
    const std::string bench = folder / "bench.json";
    const std::string film = folder / "a.film";
    const std::string picture = folder / "a.exr";
    const ProgramResult render =
        runProgram({"render", scene, "--spp", "128", "-o", picture, "--film", film, "--stats",
                    stats, "--progress", "json"});
    EXPECT_EQ(render.exitCode, 0) << render.errors;
    const std::string denoised = folder / "denoise.json";
    const ProgramResult denoise = runProgram(
        {"denoise", picture, "-o", folder / "b.exr", "--stats", denoised}, withFakeDenoiser());
    EXPECT_EQ(denoise.exitCode, 0) << denoise.errors;
    const ProgramResult measured =
        runProgram({"bench", scene, "--spp", "1", "--repeats", "1", "--json", bench});
    EXPECT_EQ(measured.exitCode, 0) << measured.errors;
    const ProgramResult study =
        runProgram({"study", scene, "--budget", "6s", "--size", "16x16", "-o", folder / "study"});
    EXPECT_EQ(study.exitCode, 0) << study.errors;
    return {{"`calotype devices", outputOf({"devices", "--json"})},
            {"`calotype info SCENE", outputOf({"info", scene, "--json"})},
            {"`calotype info FILM", outputOf({"info", film, "--json"})},
            {"`calotype compare", outputOf({"compare", picture, picture, "--json"})},
            {"`calotype render --stats", Json::parse(readText(stats))},
            {"`calotype denoise", Json::parse(readText(denoised))},
            {"`calotype render --progress", lastProgressLine(render.errors)},
            {"`calotype bench", Json::parse(readText(bench))},
            {"`calotype study", Json::parse(readText(folder / "study/study.json"))}};
}

const std::map<std::string, Json>& documents() {
    static const std::map<std::string, Json> all = writeDocuments();
    return all;
}

/// "integer", "number", "list", ...; empty for null, which every key can have.
std::string typeOf(const Json& value) {
    if (value.is_null())
        return "";
    return value.is_number_integer() ? "integer" : value.type_name();
}

TEST(JsonDocumentsTest, HaveTheKeysOfTheirPage) {
    const std::vector<Section> sections = sectionsOfPage();
    const std::map<std::string, Json>& all = documents();
    EXPECT_EQ(sections.size(), all.size());
    std::set<std::string> known = {"format", "version"};
    for (const Setting& setting : settingsTable())
        known.insert(setting.name);
    for (const std::string& key : keysOf(all.at("`calotype render --stats").at("error")))
        known.insert(key); // other sections refer to that of --stats
    for (const auto& [heading, document] : all) {
        const Section& section = sectionOf(sections, heading);
        const std::set<std::string> keys = keysOf(document);
        for (const std::string& key : keys)
            EXPECT_TRUE(section.known.contains(key) || known.contains(key))
                << heading << ": docs/json.md lacks the key " << key;
        for (const std::string& key : section.required)
            EXPECT_TRUE(keys.contains(key)) << heading << ": no document has the key " << key;
    }
}

TEST(JsonDocumentsTest, HaveOneTypeForEachKey) {
    std::map<std::string, std::pair<std::string, std::string>> firsts; // type and document by key
    for (const auto& [heading, document] : documents())
        for (const auto& [key, value] : document.items()) {
            // A time in an update; elsewhere times by stage.
            if (key == "seconds" && heading.find("--progress") != std::string::npos)
                continue;
            const std::string type = typeOf(value);
            if (type.empty())
                continue;
            const auto [first, isNew] = firsts.try_emplace(key, type, heading);
            EXPECT_EQ(first->second.first, type)
                << key << " in " << first->second.second << " and in " << heading;
        }
    EXPECT_GT(firsts.size(), 50u);
}

} // namespace
} // namespace calotype::test
