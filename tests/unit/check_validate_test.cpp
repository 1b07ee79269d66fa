// Scenes made in memory meet the checks that scene files meet.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "check/validate.h"

namespace calotype::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Mesh triangle() {
    Mesh mesh;
    mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    constexpr uint32_t kNone = Mesh::kNoNormal;
    mesh.triangles = {{{0, 1, 2}, {kNone, kNone, kNone}, 0}};
    return mesh;
}

/// A sphere, a triangle, an image and a light.
Scene validScene() {
    Scene scene;
    scene.background = glm::dvec3(1.0);
    scene.materials.resize(1);
    scene.materials[0].name = "wall";
    scene.materials[0].color = glm::dvec3(0.5);
    const TexelImage grey{1, 1, {128, 128, 128, 255}, {}, true, false};
    scene.textures.push_back({"grey", ImageTexture{std::make_shared<const TexelImage>(grey)}});
    Sphere sphere;
    sphere.worldFromObject.translation = {0.0, 0.0, -3.0};
    scene.shapes.push_back({sphere, 0, ""});
    scene.shapes.push_back({triangle(), 0, ""});
    return scene;
}

Mesh& meshOf(Scene& scene) { return std::get<Mesh>(scene.shapes[1].geometry); }
Sphere& sphereOf(Scene& scene) { return std::get<Sphere>(scene.shapes[0].geometry); }

TEST(ValidateTest, AcceptsAValidSceneWithoutWarnings) {
    Warnings warnings;
    validate(validScene(), warnings);
    EXPECT_TRUE(warnings.sentences().empty()) << warnings.sentences().front();
}

struct Mistake {
    std::string sentence; ///< what the error says, from its start
    std::function<void(Scene&)> make;
};

TEST(ValidateTest, RefusesBadValuesWithTheirPlaceAndRange) {
    const std::vector<Mistake> mistakes = {
        {"scene: /camera/fov: must be between 0 and 180, both excluded, not 360",
         [](Scene& s) { s.camera.verticalFov = 2.0 * M_PI; }},
        {"scene: /camera/position/1: must be a finite number, not inf",
         [](Scene& s) { s.camera.position.y = kInfinity; }},
        {"scene: /camera: must be a rotation", [](Scene& s) { s.camera.up = s.camera.right; }},
        {"scene: /camera: must be a rotation", [](Scene& s) { s.camera.right *= NAN; }},
        {"scene: /camera/lens_radius: must be 0 or greater, not -1",
         [](Scene& s) { s.camera.lensRadius = -1.0; }},
        {"scene: /camera/focus_distance: must be greater than 0, not 0",
         [](Scene& s) { s.camera.focusDistance = 0.0; }},
        {"scene: /camera/height: must be greater than 0, not -2",
         [](Scene& s) {
             s.camera.projection = Projection::Orthographic;
             s.camera.viewHeight = -2.0;
         }},
        {"scene: /film/width: must be a whole number from 1 to 65535, not 0",
         [](Scene& s) { s.film.width = 0; }},
        {"scene: /film/height: must be a whole number from 1 to 65535, not 70000",
         [](Scene& s) { s.film.height = 70000; }},
        {"scene: /render/spp: must be", [](Scene& s) { s.render.samplesPerPixel = 0; }},
        {"scene: /render/max_bounces: must be", [](Scene& s) { s.render.maxBounces = ~0u; }},
        {"scene: /background/2: must be 0 or greater, not -1",
         [](Scene& s) { s.background.z = -1.0; }},
        {"scene: /background: emits a radiance", [](Scene& s) { s.background.z = 1e31; }},
        {"scene: texture \"grey\": has no image",
         [](Scene& s) { std::get<ImageTexture>(s.textures[0].source).image = nullptr; }},
        {"scene: texture \"grey\": must hold four values a texel",
         [](Scene& s) {
             const TexelImage small{2, 1, {0, 0, 0, 0}, {}, false, true};
             std::get<ImageTexture>(s.textures[0].source).image =
                 std::make_shared<const TexelImage>(small);
         }},
        {"scene: texture \"grey\"/scale: must be in [-1e+09, 1e+09], not 1e+10",
         [](Scene& s) { s.textures[0].scale.y = 1e10; }},
        {"scene: texture \"grey\"/colors/0: must be in [0, 1], not 2",
         [](Scene& s) {
             s.textures[0].source = CheckerTexture{{glm::dvec3(2.0), {}}};
         }},
        {"scene: material \"wall\"/color/0: must be in [0, 1], not 1.5",
         [](Scene& s) { s.materials[0].color.x = 1.5; }},
        {"scene: material \"wall\"/emission/0: must be 0 or greater, not -3",
         [](Scene& s) { s.materials[0].emission = glm::dvec3(-3.0); }},
        {"scene: material \"wall\"/opacity: must be in [0, 1], not nan",
         [](Scene& s) { s.materials[0].opacity = NAN; }},
        {"scene: material \"wall\"/roughness: must be in [0, 1], not -1",
         [](Scene& s) {
             s.materials[0].type = MaterialType::Metal;
             s.materials[0].roughness = -1.0;
         }},
        {"scene: material \"wall\"/ior: must be in [0.01, 100], not 0",
         [](Scene& s) {
             s.materials[0].type = MaterialType::Dielectric;
             s.materials[0].ior = 0.0;
         }},
        {"scene: material \"wall\": a dielectric cannot emit light",
         [](Scene& s) {
             s.materials[0].type = MaterialType::Dielectric;
             s.materials[0].emission = glm::dvec3(1.0);
         }},
        {"scene: material \"wall\": has an unknown type",
         [](Scene& s) { s.materials[0].type = static_cast<MaterialType>(99); }},
        {"scene: material \"wall\": names texture 1 of 1",
         [](Scene& s) { s.materials[0].colorTexture = 1; }},
        {"scene: material \"wall\": has a normal map or an alpha texture that is not an image",
         [](Scene& s) {
             s.textures[0].source = CheckerTexture{};
             s.materials[0].normalMap = 0;
         }},
        {"scene: /shapes/0/radius: must be greater than 0, not inf",
         [](Scene& s) { sphereOf(s).radius = kInfinity; }},
        {"scene: /shapes/0: must be a rotation",
         [](Scene& s) { sphereOf(s).worldFromObject.rotation *= 2.0; }},
        {"scene: /shapes/0/translation/0: must be a finite number",
         [](Scene& s) { sphereOf(s).worldFromObject.translation.x = NAN; }},
        {"scene: /shapes/0: uses material 1 of 1", [](Scene& s) { s.shapes[0].material = 1; }},
        {"scene: /shapes/0/height: must be greater than 0, not 0",
         [](Scene& s) {
             s.shapes[0].geometry = Cone{{}, 0.0, 1.0};
         }},
        {"scene: /shapes/0/slope: must be greater than 0, not -1",
         [](Scene& s) {
             s.shapes[0].geometry = Cone{{}, 1.0, -1.0};
         }},
        {"scene: /shapes/0/height: must be greater than 0, not -1",
         [](Scene& s) {
             s.shapes[0].geometry = Cylinder{{}, 1.0, -1.0};
         }},
        {"scene: /shapes/0/radius: must be greater than 0, not 0",
         [](Scene& s) {
             s.shapes[0].geometry = Disk{{}, 0.0};
         }},
        {"scene: /shapes/1: has no triangles", [](Scene& s) { meshOf(s).triangles.clear(); }},
        {"scene: /shapes/1: uses material 7 of 1",
         [](Scene& s) { meshOf(s).triangles[0].material = 7; }},
        {"scene: /shapes/1: has a triangle with a vertex that does not exist",
         [](Scene& s) { meshOf(s).triangles[0].position[2] = 3; }},
        {"scene: /shapes/1: has a triangle with a vertex that does not exist",
         [](Scene& s) { meshOf(s).triangles[0].normal[1] = 0; }},
        {"scene: /shapes/1: has a triangle with a vertex that does not exist",
         [](Scene& s) { meshOf(s).triangles[0].uv[0] = 0; }},
        {"scene: /shapes/1: has a position that is not finite",
         [](Scene& s) { meshOf(s).positions[0].x = NAN; }},
        {"scene: /shapes/1: has a normal whose length is not 1",
         [](Scene& s) {
             meshOf(s).normals.emplace_back(0.0, 2.0, 0.0);
             std::ranges::fill(meshOf(s).triangles[0].normal, 0u);
         }},
        {"scene: /shapes/1/uvs: must be in [-1e+09, 1e+09], not 1e+10",
         [](Scene& s) { meshOf(s).uvs.emplace_back(0.0, 1e10); }},
    };
    for (const Mistake& mistake : mistakes) {
        Scene scene = validScene();
        mistake.make(scene);
        Warnings warnings;
        try {
            validate(scene, warnings);
            ADD_FAILURE() << "accepted: " << mistake.sentence;
        } catch (const SceneError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(mistake.sentence))
                << error.what() << "\nshould start with\n"
                << mistake.sentence;
        }
    }
}

TEST(ValidateTest, NamesItsOwnPlaceWhereAShapeHasOne) {
    Scene scene = validScene();
    scene.shapes[0].place = "chair.gltf: /nodes/3";
    sphereOf(scene).radius = 0.0;
    Warnings warnings;
    try {
        validate(scene, warnings);
        ADD_FAILURE();
    } catch (const SceneError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("chair.gltf: /nodes/3/radius: "))
            << error.what();
    }
}

TEST(ValidateTest, WarnsOfScenesMadeInMemory) {
    Scene scene = validScene();
    scene.background = glm::dvec3(0.0);
    Warnings warnings;
    validate(scene, warnings);
    ASSERT_EQ(warnings.sentences().size(), 1u);
    EXPECT_EQ(warnings.sentences()[0], "scene: nothing emits light, so the picture will be black");
}

} // namespace
} // namespace calotype::test
