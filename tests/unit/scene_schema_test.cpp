// The scenes that come with the project load, and agree with the schema.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <sys/wait.h>

#include "read/json/scene.h"
#include "scene_files.h"
#include "support/paths.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

const fs::path kSourceFolder = kProjectFolder;

nlohmann::json readJson(const fs::path& path) {
    std::ifstream file(path);
    const bool allowExceptions = true;
    const bool ignoreComments = true;
    return nlohmann::json::parse(file, nullptr, allowExceptions, ignoreComments);
}

std::vector<fs::path> sceneFiles() {
    std::vector<fs::path> scenes;
    for (const auto& entry : fs::directory_iterator(kSourceFolder / "scenes"))
        if (entry.path().extension() == ".json" && entry.path().filename() != "scene.schema.json")
            scenes.push_back(entry.path());
    return scenes;
}

/// All keys of objects under `json`, save those that are names of the user's own.
void collectKeys(const nlohmann::json& json, std::set<std::string>& keys) {
    for (const auto& [key, value] : json.items()) {
        const bool names = key == "materials" || key == "textures";
        if (json.is_object())
            keys.insert(key);
        if (names && json.is_object())
            for (const auto& [unused, named] : value.items())
                collectKeys(named, keys);
        else if (value.is_structured())
            collectKeys(value, keys);
    }
}

/// The keys of every "properties" in the schema.
void collectProperties(const nlohmann::json& schema, std::set<std::string>& keys) {
    for (const auto& [key, value] : schema.items()) {
        if (key == "properties" && schema.is_object())
            for (const auto& [property, unused] : value.items())
                keys.insert(property);
        if (value.is_structured())
            collectProperties(value, keys);
    }
}

TEST(SceneSchemaTest, EverySceneLoadsWithoutWarnings) {
    const std::vector<fs::path> scenes = sceneFiles();
    EXPECT_GE(scenes.size(), 9u);
    for (const fs::path& path : scenes) {
        const Scene scene = loadScene(path.string());
        EXPECT_FALSE(scene.shapes.empty()) << path;
        EXPECT_TRUE(scene.warnings.empty()) << path << ": " << scene.warnings.front();
    }
}

TEST(SceneSchemaTest, HasEveryKeyInTheScenes) {
    std::set<std::string> known;
    collectProperties(readJson(kSourceFolder / "scenes" / "scene.schema.json"), known);
    for (const fs::path& path : sceneFiles()) {
        std::set<std::string> used;
        collectKeys(readJson(path), used);
        for (const std::string& key : used)
            EXPECT_TRUE(known.contains(key)) << path << " uses " << key;
    }
}

TEST(SceneSchemaTest, IsWhatTheReadersTablesSay) {
    std::ifstream file(kSourceFolder / "scenes" / "scene.schema.json");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text, sceneSchema()) << "write it anew: calotype schema > scenes/scene.schema.json";
}

/// Expects a description of each value of each "properties" below `schema`.
void expectDescriptions(const nlohmann::json& schema, const std::string& place) {
    for (const auto& [key, value] : schema.items()) {
        if (key == "properties" && schema.is_object() && !place.ends_with("/if")) {
            for (const auto& [property, described] : value.items()) {
                EXPECT_FALSE(described.value("description", "").empty())
                    << place << " " << property;
            }
        }
        if (value.is_structured())
            expectDescriptions(value, place + "/" + key);
    }
}

TEST(SceneSchemaTest, DescribesEveryKey) {
    expectDescriptions(nlohmann::json::parse(sceneSchema()), "");
}

TEST(SceneSchemaTest, ValidatesTheScenesAndRefusesBrokenOnes) {
    constexpr int kModuleMissing = 77;
    constexpr int kCommandMissing = 127;
    const fs::path script = kSourceFolder / "tests" / "unit" / "schema_check.py";
    const std::string command =
        "python3 '" + script.string() + "' '" + (kSourceFolder / "scenes").string() + "'";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kModuleMissing || WEXITSTATUS(status) == kCommandMissing)
        GTEST_SKIP() << "python3 with jsonschema is not installed";
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

} // namespace
} // namespace calotype::test
