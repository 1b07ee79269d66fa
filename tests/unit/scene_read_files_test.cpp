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

} // namespace
} // namespace calotype::test
