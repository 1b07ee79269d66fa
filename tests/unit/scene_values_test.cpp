// What the reader makes of right values: camera, colours, settings, lights, warnings.

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scene_files.h"

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;
/// A few roundings of numbers near one.
constexpr double kRounding = 1e-15;

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected,
                double tolerance = kRounding) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

Camera cameraOf(const std::string& camera) {
    const SceneFiles files;
    return files.loadText("{\"camera\": " + camera + "}").camera;
}

Material materialOf(const std::string& material) {
    const SceneFiles files;
    return files.loadText("{\"camera\": {}, \"materials\": {\"m\": " + material + "}}")
        .materials.at(0);
}

TEST(SceneValuesTest, CameraDefaultsLookAlongMinusZ) {
    const Camera camera = cameraOf("{\"position\": [1, 2, 3]}");
    expectNear(camera.position, {1, 2, 3});
    expectNear(camera.forward, {0, 0, -1});
    expectNear(camera.right, {1, 0, 0});
    expectNear(camera.up, {0, 1, 0});
    EXPECT_NEAR(camera.verticalFov, 40.0 * kPi / 180.0, kRounding);
}

TEST(SceneValuesTest, CameraLooksAtItsTargetWithOrthonormalAxes) {
    // Looking along +X with a tilted up: right is +Z, and up loses its part along the view.
    const Camera camera = cameraOf(
        "{\"position\": [0, 1, 0], \"target\": [7, 1, 0], \"up\": [3, 2, 0], \"fov\": 90}");
    expectNear(camera.forward, {1, 0, 0});
    expectNear(camera.right, {0, 0, 1});
    expectNear(camera.up, {0, 1, 0});
    EXPECT_NEAR(camera.verticalFov, kPi / 2.0, kRounding);
}

TEST(SceneValuesTest, OrthographicCamerasHaveAHeight) {
    const Camera camera = cameraOf(R"({"type": "orthographic", "height": 3, "lens_radius": 0.5,
                                       "position": [0, 0, 5], "focus_distance": 2})");
    EXPECT_EQ(camera.projection, Projection::Orthographic);
    EXPECT_EQ(camera.viewHeight, 3.0);
    EXPECT_EQ(camera.lensRadius, 0.5);
    EXPECT_EQ(camera.focusDistance, 2.0);
    EXPECT_EQ(cameraOf(R"({"type": "perspective"})").projection, Projection::Perspective);
}

TEST(SceneValuesTest, LensesFocusOnTheTargetByDefault) {
    // 3, 4 and 12 make 13.
    const std::string at = R"({"position": [1, 1, 1], "target": [4, 5, 13], "lens_radius": 0.1)";
    EXPECT_NEAR(cameraOf(at + "}").focusDistance, 13.0, 13.0 * kRounding);
    EXPECT_EQ(cameraOf(at + R"(, "focus_distance": 2.5})").focusDistance, 2.5);
    EXPECT_EQ(cameraOf(at + "}").lensRadius, 0.1);
    EXPECT_EQ(cameraOf(R"({"lens_radius": 0})").lensRadius, 0.0); // a pinhole needs no distance
}

TEST(SceneValuesTest, CameraMatrixIsWorldFromCamera) {
    // A quarter turn about Y: the camera's -Z becomes the world's -X.
    const Camera camera = cameraOf("{\"matrix\": [0,0,1,5, 0,1,0,6, -1,0,0,7, 0,0,0,1]}");
    expectNear(camera.position, {5, 6, 7});
    expectNear(camera.right, {0, 0, -1});
    expectNear(camera.up, {0, 1, 0});
    expectNear(camera.forward, {-1, 0, 0});
}

TEST(SceneValuesTest, CameraMatrixMustBeRigid) {
    for (const char* matrix :
         {"[2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]", "[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]",
          "[1,0.1,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"}) {
        const SceneError error =
            errorOf([&] { cameraOf(std::string("{\"matrix\": ") + matrix + "}"); });
        expectError(error, "scene.json: /camera/matrix", "scales, shears or mirrors");
    }
    const SceneError error = errorOf(
        [] { cameraOf("{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], \"up\": [0, 1, 0]}"); });
    expectError(error, "scene.json: /camera/up", "exclude each other");
}

TEST(SceneValuesTest, ColoursComeInThreeNotations) {
    EXPECT_EQ(materialOf(R"({"type": "diffuse", "color": 0.25})").color, glm::dvec3(0.25));
    EXPECT_EQ(materialOf(R"({"type": "diffuse", "color": [0, 0.5, 1]})").color,
              glm::dvec3(0.0, 0.5, 1.0));
    // IEC 61966-2-1 of 255/255, 128/255 and 10/255 (the last on the linear piece).
    const Material hex = materialOf(R"({"type": "diffuse", "color": "#fF800a"})");
    expectNear(hex.color, {1.0, 0.21586050011389926, 10.0 / 255.0 / 12.92});
}

TEST(SceneValuesTest, EmissionAndItsSide) {
    const Material both = materialOf(R"({"type": "diffuse", "color": 0, "emission": [12, 11, 9]})");
    EXPECT_EQ(both.emission, glm::dvec3(12.0, 11.0, 9.0));
    EXPECT_FALSE(both.emitsFromFrontOnly);
    EXPECT_TRUE(both.visibleToCamera);
    EXPECT_TRUE(materialOf(R"({"type": "diffuse", "color": 0, "emission": 1,
                               "emission_side": "front"})")
                    .emitsFromFrontOnly);
}

TEST(SceneValuesTest, FilmAndRenderSettings) {
    const SceneFiles files;
    const Scene defaults = files.loadText(R"({"camera": {}})");
    EXPECT_EQ(defaults.film.width, 640u);
    EXPECT_EQ(defaults.film.height, 480u);
    EXPECT_EQ(defaults.render.samplesPerPixel, 64u);
    EXPECT_EQ(defaults.render.maxBounces, 4u);
    EXPECT_EQ(defaults.render.seed, 0u);
    EXPECT_EQ(defaults.render.denoiser, DenoiserKind::Off);
    EXPECT_FALSE(defaults.render.hidesBackground);
    const Scene set = files.loadText(R"({"camera": {}, "film": {"width": 65535, "height": 1},
        "render": {"spp": 8.0, "max_bounces": 0, "seed": 4294967295, "denoise": "oidn",
                   "transparent": true}})");
    EXPECT_EQ(set.film.width, 65535u);
    EXPECT_EQ(set.film.height, 1u);
    EXPECT_EQ(set.render.samplesPerPixel, 8u);
    EXPECT_EQ(set.render.maxBounces, 0u);
    EXPECT_EQ(set.render.seed, 4294967295u);
    EXPECT_EQ(set.render.denoiser, DenoiserKind::Oidn);
    EXPECT_TRUE(set.render.hidesBackground);
}

TEST(SceneValuesTest, EveryFilmFilter) {
    const SceneFiles files;
    const auto filterOf = [&](const std::string& name) {
        return files.loadText("{\"camera\": {}, \"film\": {\"filter\": \"" + name + "\"}}")
            .film.filter;
    };
    EXPECT_EQ(filterOf("box"), FilmFilter::Box);
    EXPECT_EQ(filterOf("tent"), FilmFilter::Tent);
    EXPECT_EQ(filterOf("gaussian"), FilmFilter::Gaussian);
    EXPECT_EQ(filterOf("blackman-harris"), FilmFilter::BlackmanHarris);
    EXPECT_EQ(files.loadText(R"({"camera": {}})").film.filter, FilmFilter::Box);
}

TEST(SceneValuesTest, LightsBearBlackEmittingMaterialsOfTheirOwn) {
    const SceneFiles files;
    nlohmann::json scene =
        sceneWithLight(R"({"type": "disk", "radius": 1, "radiance": [3, 2, 1]})");
    scene["lights"].push_back(nlohmann::json::parse(R"({"type": "quad", "radiance": 5,
        "two_sided": true, "visible": false,
        "vertices": [[-1, 3, -1], [1, 3, -1], [1, 3, 1], [-1, 3, 1]]})"));
    const Scene loaded = files.load(scene);
    ASSERT_EQ(loaded.shapes.size(), 2u);
    const Material& first = loaded.materials.at(loaded.shapes[0].material);
    EXPECT_EQ(first.name, "light 0");
    EXPECT_EQ(first.color, glm::dvec3(0.0));
    EXPECT_EQ(first.emission, glm::dvec3(3.0, 2.0, 1.0));
    EXPECT_TRUE(first.emitsFromFrontOnly);
    EXPECT_TRUE(first.visibleToCamera);
    const Material& second = loaded.materials.at(loaded.shapes[1].material);
    EXPECT_EQ(second.name, "light 1");
    EXPECT_FALSE(second.emitsFromFrontOnly);
    EXPECT_FALSE(second.visibleToCamera);
    EXPECT_EQ(std::get<Mesh>(loaded.shapes[1].geometry).triangles.at(1).material,
              loaded.shapes[1].material);
}

TEST(SceneValuesTest, PowerIsSpreadOverAreaSidesAndDirections) {
    const SceneFiles files;
    const auto radianceOf = [&](const std::string& light) {
        const Scene scene = files.load(sceneWithLight(light));
        return scene.materials.at(scene.shapes.at(0).material).emission.x;
    };
    // 2 by 2 metres; Lambert: power = pi * area * radiance.
    const std::string quad = R"({"type": "quad", "power": 8,
        "vertices": [[-1, 3, -1], [1, 3, -1], [1, 3, 1], [-1, 3, 1]])";
    EXPECT_NEAR(radianceOf(quad + "}"), 8.0 / (kPi * 4.0), kRounding);
    EXPECT_NEAR(radianceOf(quad + ", \"two_sided\": true}"), 8.0 / (kPi * 8.0), kRounding);
    EXPECT_NEAR(radianceOf(quad + ", \"transform\": {\"scale\": [3, 1, 1]}}"), 8.0 / (kPi * 12.0),
                kRounding);
    EXPECT_NEAR(radianceOf(R"({"type": "disk", "radius": 0.5, "power": 1,
                               "transform": {"scale": -4}})"),
                1.0 / (kPi * kPi * 4.0), kRounding);
}

TEST(SceneValuesTest, WarnsOfABlackPicture) {
    const SceneFiles files;
    const auto warningsOf = [&](const nlohmann::json& scene) { return files.load(scene).warnings; };
    ASSERT_EQ(warningsOf(plainScene()).size(), 1u);
    EXPECT_NE(
        warningsOf(plainScene())[0].find("no shapes and no lights, so the picture will be black"),
        std::string::npos);
    const auto dark = sceneWithShape(R"({"type": "sphere", "radius": 1, "material": "wall"})");
    ASSERT_EQ(warningsOf(dark).size(), 1u);
    EXPECT_NE(warningsOf(dark)[0].find("nothing emits light, so the picture will be black"),
              std::string::npos);
    EXPECT_TRUE(
        warningsOf(sceneWithLight(R"({"type": "disk", "radius": 1, "radiance": 1})")).empty());
    EXPECT_EQ(warningsOf(sceneWithLight(R"({"type": "disk", "radius": 1, "radiance": 0})")).size(),
              1u);
}

} // namespace
} // namespace calotype::test
