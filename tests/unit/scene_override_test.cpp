// --set, and the hash of what was read.

#include <set>

#include "scene_files.h"

namespace calotype::test {
namespace {

Scene loadWith(const nlohmann::json& scene, const std::string& pointer, const std::string& value) {
    const SceneFiles files;
    LoadOptions options;
    options.overrides = {{pointer, value}};
    return files.load(scene, options);
}

TEST(SceneOverrideTest, ReplacesAndAdds) {
    nlohmann::json scene = sceneWithShape(R"({"type": "sphere", "radius": 1, "material": "wall"})");
    scene["render"] = {{"spp", 4}};
    EXPECT_EQ(loadWith(scene, "/render/spp", "16").render.samplesPerPixel, 16u);
    EXPECT_EQ(loadWith(scene, "/render/seed", "7").render.seed, 7u);
    EXPECT_EQ(loadWith(scene, "/film", "{\"width\": 8, \"height\": 9}").film.height, 9u);
    EXPECT_EQ(loadWith(scene, "/materials/wall/color", "#ffffff").materials.at(0).color,
              glm::dvec3(1.0));
    EXPECT_EQ(loadWith(scene, "/materials/wall/color", "\"#ffffff\"").materials.at(0).color,
              glm::dvec3(1.0));
    EXPECT_EQ(
        std::get<Sphere>(loadWith(scene, "/shapes/0/radius", "2.5").shapes.at(0).geometry).radius,
        2.5);
    EXPECT_EQ(loadWith(scene, "/shapes/-", R"({"type": "disk", "radius": 1, "material": "wall"})")
                  .shapes.size(),
              2u);
    scene["materials"]["a/b~c"] = scene["materials"]["wall"];
    EXPECT_EQ(loadWith(scene, "/materials/a~1b~0c/color", "1").materials.at(0).color,
              glm::dvec3(1.0));
}

// --from, --look-at, --up and --fov are the camera's keys.
TEST(SceneOverrideTest, ChangesTheView) {
    const SceneFiles files;
    nlohmann::json scene = sceneWithShape(R"({"type": "sphere", "radius": 1, "material": "wall"})");
    scene["camera"] = {{"position", {0, 0, 5}}, {"target", {0, 0, 0}}, {"fov", 30}};
    LoadOptions options;
    options.view.lookAt = glm::dvec3(5, 0, 5);
    options.view.fov = 90.0;
    const Camera camera = files.load(scene, options).camera;
    EXPECT_EQ(camera.position, glm::dvec3(0, 0, 5));
    EXPECT_NEAR(glm::length(camera.forward - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
    EXPECT_NEAR(camera.verticalFov, 0.5 * 3.14159265358979, 1e-12);
    EXPECT_NE(files.load(scene, options).hash, files.load(scene).hash);
    // A matrix is replaced by a position and a target together.
    scene["camera"] = {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
    EXPECT_EQ(errorOf([&] { files.load(scene, options); }).where(), "--look-at");
    options.view.from = glm::dvec3(5, 0, 7);
    EXPECT_NEAR(glm::length(files.load(scene, options).camera.forward - glm::dvec3(0, 0, -1)), 0.0,
                1e-12);
}

TEST(SceneOverrideTest, AppliesInOrder) {
    const SceneFiles files;
    LoadOptions options;
    options.overrides = {{"/render", "{}"}, {"/render/spp", "3"}, {"/render/spp", "5"}};
    EXPECT_EQ(files.load(plainScene(), options).render.samplesPerPixel, 5u);
}

TEST(SceneOverrideTest, RefusesWithItsPointer) {
    struct Refusal {
        std::string pointer;
        std::string value;
        std::string fragment;
    };
    for (const Refusal& refusal : std::vector<Refusal>{
             {"", "{}", "cannot replace the whole scene"},
             {"render/spp", "1", "is not a JSON pointer"},
             {"/materials/a~2b", "1", "is not a JSON pointer"},
             {"/render/spp", "1", "the scene has no /render"},
             {"/camera/position/0/x", "1", "neither an object nor an array"},
             {"/camera/position/3", "1", "has 3 elements, so \"3\" is not one of them"},
             {"/camera/position/01", "1", "is not one of them"},
             {"/camera/position/x", "1", "is not one of them"},
             {"/shapes/99999999999999999999999/x", "1", "the scene has no"},
             {"/film", "{\"width\": 1, \"width\": 2}", "repeated"},
             {"/camera/\xff", "1", "must be UTF-8"},
             {"/camera/fov", "\xff", "must be UTF-8"}}) {
        const SceneError error =
            errorOf([&] { loadWith(plainScene(), refusal.pointer, refusal.value); });
        EXPECT_TRUE(error.where().starts_with("--set " + refusal.pointer)) << error.what();
        EXPECT_NE(std::string(error.what()).find(refusal.fragment), std::string::npos)
            << error.what();
    }
}

TEST(SceneOverrideTest, ValuesAreCheckedLikeTheFiles) {
    expectError(errorOf([] { loadWith(plainScene(), "/camera/fvo", "1"); }),
                "scene.json: /camera/fvo", "did you mean \"fov\"?");
    // Not JSON, so a text.
    expectError(errorOf([] { loadWith(plainScene(), "/camera/fov", "1e999"); }),
                "scene.json: /camera/fov", "must be a number, not the text \"1e999\"");
}

TEST(SceneHashTest, ChangesIfAndOnlyIfTheContentDoes) {
    const SceneFiles files;
    const char* const obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    files.write("m.obj", std::string("mtllib m.mtl\n") + obj);
    files.write("m.mtl", "newmtl a\nKd 0.5\n");
    const std::string text =
        R"({"camera": {"fov": 40}, "shapes": [{"type": "mesh", "file": "m.obj"}]})";
    const uint64_t hash = files.loadText(text).hash;
    EXPECT_NE(hash, 0u);
    EXPECT_EQ(files.loadText(text).hash, hash);
    // Order, blanks and comments are not content.
    EXPECT_EQ(files
                  .loadText(R"({ "shapes": [{"file": "m.obj", "type": "mesh"}], // c
                                  "camera": {"fov":40}})")
                  .hash,
              hash);
    LoadOptions same;
    same.overrides = {{"/camera/fov", "40"}};
    EXPECT_EQ(files.loadText(text, same).hash, hash);

    std::set<uint64_t> hashes = {hash};
    LoadOptions other;
    other.overrides = {{"/camera/fov", "41"}};
    hashes.insert(files.loadText(text, other).hash);
    files.write("m.mtl", "newmtl a\nKd 0.6\n");
    hashes.insert(files.loadText(text).hash);
    files.write("m.obj", std::string("mtllib m.mtl\n# changed\n") + obj);
    hashes.insert(files.loadText(text).hash);
    EXPECT_EQ(hashes.size(), 4u);
}

} // namespace
} // namespace calotype::test
