// The list of the files that a scene is read from: no output may replace any of them.
#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "image/png.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

class ReadFilesTest : public testing::Test {
protected:
    ReadFilesTest() {
        for (const char* name : {"color.png", "ks.png", "bump.png", "alpha.png", "plain.png"})
            writePng(files_.path(name), Rgb8Image(2, 2));
        files_.write("chair.mtl", "newmtl wood\nKd 1 1 1\nmap_Kd color.png\n");
        files_.write("more.mtl", "newmtl steel\nmap_Kd ALPHA.PNG\n");
        files_.write("chair.obj", "mtllib chair.mtl\nmtllib more.mtl\n"
                                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                  "usemtl wood\nf 1/1 2/2 3/3\nusemtl steel\nf 3/3 2/2 1/1\n");
    }

    /// The names of the files, without their folder.
    static std::multiset<std::string> names(const LoadedScene& scene) {
        std::multiset<std::string> names;
        for (const std::string& path : scene.files())
            names.insert(std::filesystem::path(path).filename().string());
        return names;
    }

    const SceneFiles files_;
};

TEST_F(ReadFilesTest, AModelsAreItsOwnItsMtlsAndItsTextures) {
    const LoadedScene scene = loadScene(files_.path("chair.obj"));
    ASSERT_EQ(names(scene), (std::multiset<std::string>{"chair.obj", "chair.mtl", "more.mtl",
                                                        "color.png", "alpha.png"}));
    EXPECT_EQ(scene.files().front(), files_.path("chair.obj"));
}

// Each file once, also where several textures have it.
TEST_F(ReadFilesTest, AScenesAreItsOwnItsModelsAndItsTextures) {
    nlohmann::json scene = sceneWithShape(R"({"type": "mesh", "file": "chair.obj"})");
    scene["shapes"].push_back(scene["shapes"][0]);
    scene["textures"] = {{"a", {{"type", "image"}, {"file", "plain.png"}}},
                         {"b", {{"type", "image"}, {"file", "./plain.png"}}}};
    scene["materials"]["wall"]["color"] = "a";
    const LoadedScene loaded = loadScene(files_.write("s.json", scene.dump()));
    const auto found = names(loaded);
    for (const char* name :
         {"s.json", "chair.obj", "chair.mtl", "more.mtl", "color.png", "alpha.png", "plain.png"})
        EXPECT_TRUE(found.contains(name)) << name;
    EXPECT_EQ(found.count("chair.obj"), 1u);
}

// One file has many spellings: it is read, decoded and kept once.
TEST_F(ReadFilesTest, AnImageIsReadOnceInAllSpellings) {
    std::filesystem::create_symlink("plain.png", files_.path("link.png"));
    const std::string folder = std::filesystem::path(files_.path("")).parent_path().filename();
    nlohmann::json scene = plainScene();
    std::string mtl;
    std::string obj = "mtllib spellings.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
    int count = 0;
    for (const std::string& name : std::initializer_list<std::string>{
             "plain.png", "./plain.png", ".//plain.png", "../" + folder + "/plain.png", "PLAIN.PNG",
             ".\\plain.png", "link.png", files_.path("plain.png")}) {
        const std::string key = std::to_string(count++);
        scene["textures"][key] = {{"type", "image"}, {"file", name}};
        mtl += "newmtl m" + key + "\nmap_Kd " + name + "\n";
        obj += "usemtl m" + key + "\nf 1/1 2/1 3/1\n";
    }
    files_.write("spellings.mtl", mtl);
    files_.write("spellings.obj", obj);
    for (const char* name : {"spellings.obj", "./spellings.obj"})
        scene["shapes"].push_back({{"type", "mesh"}, {"file", name}});
    LoadOptions options;
    options.hostMemory = 16; // that of one copy
    const LoadedScene loaded = loadScene(files_.write("s.json", scene.dump()), options);
    EXPECT_EQ(names(loaded), (std::multiset<std::string>{"s.json", "plain.png", "spellings.obj",
                                                         "spellings.mtl"}));
    std::set<const TexelImage*> images;
    for (const Texture& texture : loaded->textures)
        images.insert(std::get<ImageTexture>(texture.source).image.get());
    EXPECT_EQ(images.size(), 1u);
}

// Meshes are built on other threads, while the reader goes on.
TEST_F(ReadFilesTest, TheFirstErrorIsThatOfTheFirstShape) {
    const std::string mesh = R"({"type": "mesh", "file": "chair.obj", "material": "wall")";
    for (int repeat = 0; repeat < 20; ++repeat) {
        nlohmann::json scene = sceneWithShape(
            mesh + R"(, "transform": {"translate": [1e308, 0, 0], "scale": 1e308}})");
        scene["shapes"].push_back(nlohmann::json::parse(mesh + "}"));
        scene["shapes"].push_back(nlohmann::json::parse(R"({"type": "mesh", "file": "none.obj"})"));
        const SceneError error = errorOf([&] { files_.load(scene); });
        expectError(error, "scene.json: /shapes/0/file", "beyond the range of finite numbers");
        scene["shapes"].erase(0);
        expectError(errorOf([&] { files_.load(scene); }), "scene.json: /shapes/1/file", "none.obj");
    }
}

TEST_F(ReadFilesTest, WarningsAreInTheOrderOfTheShapes) {
    files_.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
    files_.write("line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n");
    nlohmann::json scene =
        sceneWithShape(R"({"type": "mesh", "file": "flat.obj", "material": "wall"})");
    scene["shapes"].push_back(
        nlohmann::json::parse(R"({"type": "mesh", "file": "line.obj", "material": "wall"})"));
    const auto warnings = files_.load(scene).warnings;
    const auto placeOf = [&](const char* text) {
        return std::ranges::find_if(warnings,
                                    [&](const std::string& warning) {
                                        return warning.find(text) != std::string::npos;
                                    }) -
               warnings.begin();
    };
    ASSERT_LT(placeOf("statements that are not rendered"), std::ssize(warnings));
    EXPECT_LT(placeOf("have no area"), placeOf("statements that are not rendered"));
}

// Files are read ahead of their turn; the hash is that of their order in the scene nevertheless.
TEST_F(ReadFilesTest, TheHashAndTheListAreAlwaysTheSame) {
    nlohmann::json scene = sceneWithShape(R"({"type": "mesh", "file": "chair.obj"})");
    for (const char* name : {"alpha", "bump", "color", "ks", "plain"})
        scene["textures"][name] = {{"type", "image"}, {"file", std::string(name) + ".png"}};
    files_.write("ks.png", "no image");
    const std::string path = files_.write("s.json", scene.dump());
    LoadOptions options;
    options.missingTextures = MissingTextures::Warn;
    const LoadedScene first = loadScene(path, options);
    for (int repeat = 0; repeat < 20; ++repeat) {
        const LoadedScene again = loadScene(path, options);
        EXPECT_EQ(again->hash, first->hash);
        EXPECT_EQ(again.files(), first.files());
        EXPECT_EQ(again->warnings, first->warnings);
    }
}

TEST_F(ReadFilesTest, TheHashDependsOnFilesThatAreReadAhead) {
    nlohmann::json scene =
        sceneWithShape(R"({"type": "mesh", "file": "m.obj", "material": "wall"})");
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    files_.write("m.obj", text);
    const uint64_t first = files_.load(scene).hash;
    files_.write("m.obj", text + "# changed");
    EXPECT_NE(files_.load(scene).hash, first);
}

} // namespace
} // namespace calotype::test
