// The names of objects and materials in mattes.
#include "scene/matte_names.h"

#include <bit>
#include <cstdio>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/cryptomatte.h"
#include "scene_files.h"

namespace calotype::test {
namespace {

using Names = std::vector<std::string>;

const std::string kScene = R"({"camera": {},
    "materials": { "red": { "type": "diffuse", "color": 1 },
                   "glass": { "type": "dielectric", "ior": 1.5 } },
    "shapes": [
      { "type": "sphere", "center": [0,0,0], "radius": 1, "material": "glass" },
      { "type": "quad", "vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "red",
        "name": "wall" },
      { "type": "mesh", "file": "m.obj", "materials": { "a": "red", "b": "glass" } },
      { "type": "triangle", "vertices": [[0,0,0],[1,0,0],[0,1,0]], "material": "red",
        "name": "wall" } ],
    "lights": [
      { "type": "disk", "center": [0,3,0], "normal": [0,-1,0], "radius": 1, "radiance": 1 },
      { "type": "disk", "center": [0,3,0], "normal": [0,-1,0], "radius": 1, "radiance": 1,
        "name": "lamp" } ]})";

const std::string kMesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 2\n";

TEST(MatteNamesTest, FollowTheOrderOfPrimitives) {
    const SceneFiles files;
    files.write("m.obj", kMesh);
    const Scene scene = files.loadText(kScene);
    const MatteNames objects = objectNames(scene);
    EXPECT_EQ(objects.names, (Names{"sphere 0", "wall", "mesh 2", "light 0", "lamp"}));
    EXPECT_EQ(objects.ofPrimitives, (std::vector<uint32_t>{0, 1, 1, 2, 2, 1, 3, 4}));
    const MatteNames materials = materialNames(scene);
    Names ofPrimitives;
    for (const uint32_t index : materials.ofPrimitives)
        ofPrimitives.push_back(materials.names[index]);
    EXPECT_EQ(ofPrimitives,
              (Names{"glass", "red", "red", "red", "glass", "red", "light 0", "light 1"}));
}

TEST(MatteNamesTest, ScenesWithoutNamesHaveDefaults) {
    Scene scene;
    scene.materials.resize(2);
    scene.materials[0].name = "m";
    scene.shapes.push_back({Sphere{}, 1, ""});
    scene.shapes.push_back({Disk{}, 0, ""});
    EXPECT_EQ(objectNames(scene).names, (Names{"shape 0", "shape 1"}));
    EXPECT_EQ(materialNames(scene).names, (Names{"m", "material 1"}));
    EXPECT_EQ(materialNames(scene).ofPrimitives, (std::vector<uint32_t>{1, 0}));
}

// Ids are the hashes of names in the manifest, which is UTF-8.
TEST(MatteNamesTest, AreInUtf8) {
    Scene scene;
    scene.materials.resize(3);
    scene.materials[0].name = "caf\xe9";
    scene.materials[1].name = "caf\xe8";
    scene.materials[2].name = "caf\xc3\xa9";
    for (const uint32_t material : {0u, 1u, 2u})
        scene.shapes.push_back({Sphere{}, material, "", "", scene.materials[material].name});
    for (const MatteNames& names : {objectNames(scene), materialNames(scene)}) {
        EXPECT_EQ(names.names, (Names{"caf\xef\xbf\xbd", "caf\xc3\xa9"}));
        EXPECT_EQ(names.ofPrimitives, (std::vector<uint32_t>{0, 0, 1}));
        const auto attributes = cryptomatteAttributes("CryptoMaterial", names.names);
        const auto manifest = nlohmann::json::parse(std::get<std::string>(attributes.back().value));
        for (const auto& [name, id] : manifest.items()) {
            char expected[9];
            std::snprintf(expected, sizeof expected, "%08x",
                          std::bit_cast<uint32_t>(cryptomatteId(name)));
            EXPECT_EQ(id, expected) << name;
        }
        EXPECT_EQ(manifest.size(), names.names.size());
    }
}

TEST(MatteNamesTest, AnEmptyNameIsRefused) {
    const SceneFiles files;
    try {
        files.loadText(R"({"camera": {}, "lights": [
          { "type": "disk", "center": [0,3,0], "normal": [0,-1,0], "radius": 1, "radiance": 1,
            "name": "" } ]})");
        ADD_FAILURE();
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("/lights/0/name"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("is empty"), std::string::npos);
    }
}

} // namespace
} // namespace calotype::test
