// The scene that is made around a bare OBJ file.

#include <cmath>

#include <glm/geometric.hpp>

#include "unit/scene_files.h"

namespace calotype::test {
namespace {

/// A box from `lower` to `upper` as an OBJ; only its corners matter.
std::string boxObj(const glm::dvec3& lower, const glm::dvec3& upper) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
        const double x = i % 2 ? upper.x : lower.x;
        const double y = i / 2 % 2 ? upper.y : lower.y;
        const double z = i / 4 ? upper.z : lower.z;
        char line[100];
        std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", x, y, z);
        text += line;
    }
    return text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
}

class ModelSceneTest : public testing::Test {
protected:
    Scene load(const std::string& obj) { return loadScene(files_.write("m.obj", obj)); }

    SceneFiles files_;
};

const Mesh& modelOf(const Scene& scene) { return std::get<Mesh>(scene.shapes.at(0).geometry); }

/// The furthest reach of the model in a square picture, across or up; 1 is its edge.
double reach(const Scene& scene) {
    double furthest = 0.0;
    const Camera& camera = scene.camera;
    for (const glm::dvec3& position : modelOf(scene).positions) {
        const glm::dvec3 p = position - camera.position;
        const double depth = glm::dot(p, camera.forward);
        EXPECT_GT(depth, 0.0);
        const double edge = depth * std::tan(0.5 * camera.verticalFov);
        furthest = std::max({furthest, std::abs(glm::dot(p, camera.right)) / edge,
                             std::abs(glm::dot(p, camera.up)) / edge});
    }
    return furthest;
}

TEST_F(ModelSceneTest, ModelsOfEverySizeAndShapeFillNineTenths) {
    const std::vector<std::pair<glm::dvec3, glm::dvec3>> boxes = {
        {{-1, -1, -1}, {1, 1, 1}},    {{0, 0, 0}, {1e-3, 2e-3, 1e-3}},
        {{0, 0, 0}, {1e5, 2e4, 3e4}}, {{-5, 0, -0.1}, {5, 0.1, 0.1}},
        {{0, 0, 0}, {0.1, 30, 0.1}},  {{1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 2, 1e6 + 3}},
        {{-1, 0, -1}, {1, 0, 1}}};
    for (const auto& [lower, upper] : boxes) {
        const Scene scene = load(boxObj(lower, upper));
        SCOPED_TRACE(upper.x);
        EXPECT_NEAR(reach(scene), 0.9, 1e-6);
        const Camera& camera = scene.camera;
        EXPECT_LE(camera.verticalFov, 40.0 * 3.14159265358979 / 180.0);
        EXPECT_LT(camera.forward.y, 0.0);           // from above
        EXPECT_GT(std::abs(camera.forward.x), 0.1); // at an angle
        EXPECT_NEAR(glm::dot(camera.forward, camera.up), 0.0, 1e-12);
        EXPECT_NEAR(glm::length(glm::cross(camera.right, camera.up) + camera.forward), 0.0, 1e-12);
    }
}

TEST_F(ModelSceneTest, StandsOnAFloorThatFillsThePicture) {
    for (const double size : {1e-3, 1.0, 1e5}) {
        const Scene scene = load(boxObj({0, 0, 0}, {size, 3 * size, size}));
        const Shape& shape = scene.shapes.at(1);
        const auto& floor = std::get<Disk>(shape.geometry);
        const glm::dvec3 center = floor.worldFromObject.translation;
        EXPECT_LT(center.y, 0.0);
        EXPECT_GT(center.y, -0.01 * size);
        const glm::dvec3 color = scene.materials.at(shape.material).color;
        EXPECT_EQ(color, glm::dvec3(color.x)); // neutral
        // The corners of a picture three times as wide as high.
        const Camera& camera = scene.camera;
        const double edge = std::tan(0.5 * camera.verticalFov);
        for (const double across : {-3.0 * edge, 3.0 * edge}) {
            const glm::dvec3 ray = camera.forward + across * camera.right + edge * camera.up;
            ASSERT_LT(ray.y, 0.0);
            const double distance = (center.y - camera.position.y) / ray.y;
            EXPECT_LT(glm::length(camera.position + distance * ray - center), floor.radius);
        }
    }
}

/// The light's irradiance on a surface at the origin that faces it, its area taken as a point.
double irradiance(const Scene& scene, const Shape& light, const glm::dvec3& target) {
    const Mesh& mesh = std::get<Mesh>(light.geometry);
    const auto& p = mesh.positions;
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[3] - p[0]); // its length is the area
    const glm::dvec3 center = 0.5 * (p[0] + p[2]);
    const glm::dvec3 toTarget = target - center;
    const double distance = glm::length(toTarget);
    return scene.materials.at(light.material).emission.x * glm::dot(normal, toTarget) /
           (distance * distance * distance);
}

TEST_F(ModelSceneTest, IsLitAlikeWhateverItsSize) {
    std::vector<double> light;
    for (const double size : {1e-3, 1.0, 1e5}) {
        const Scene scene = load(boxObj({0, 0, 0}, {size, size, size}));
        ASSERT_EQ(scene.shapes.size(), 4u);
        const double key = irradiance(scene, scene.shapes[2], glm::dvec3(0.5 * size));
        const double fill = irradiance(scene, scene.shapes[3], glm::dvec3(0.5 * size));
        EXPECT_GT(key, 2.0 * fill); // also: both shine towards the model
        EXPECT_GT(fill, 0.1);
        for (const size_t i : {2u, 3u})
            for (const glm::dvec3& p : std::get<Mesh>(scene.shapes[i].geometry).positions)
                EXPECT_GT(p.y, size); // from above
        light.push_back(key);
        EXPECT_GT(scene.background.x, 0.0);
        // A white surface that faces the key light, pi of which is 1: neither dark nor burnt out.
        EXPECT_GT(key + 3.14 * scene.background.x, 0.5 * 3.14);
        EXPECT_LT(key + 3.14 * scene.background.x, 3.14);
    }
    EXPECT_NEAR(light[0] / light[1], 1.0, 1e-9);
    EXPECT_NEAR(light[2] / light[1], 1.0, 1e-9);
}

/// Adds a square floor of two triangles in y = 0, `half` to each side; its corners are shared or
/// not.
std::string withFloor(const std::string& obj, double half, bool sharesCorners) {
    const std::string h = std::to_string(half);
    std::string text = obj + "v -" + h + " 0 " + h + "\nv " + h + " 0 " + h + "\nv " + h + " 0 -" +
                       h + "\nv -" + h + " 0 -" + h + "\n";
    if (sharesCorners)
        return text + "f -4 -3 -2 -1\n";
    return text + "f -4 -3 -2\nv -" + h + " 0 " + h + "\nv " + h + " 0 -" + h + "\nv -" + h +
           " 0 -" + h + "\nf -3 -2 -1\n";
}

// The camera is that of the model without the floor, and the warning says so.
TEST_F(ModelSceneTest, ShowsWhatStandsOnAFloorManyTimesLarger) {
    const std::string box = boxObj({-1, 0.01, -1}, {1, 2, 1});
    const Camera alone = load(box).camera;
    for (const bool sharesCorners : {true, false}) {
        const Scene scene = load(withFloor(box, 200.0, sharesCorners));
        EXPECT_NEAR(glm::length(scene.camera.position - alone.position), 0.0, 1e-9);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_NE(scene.warnings[0].find("shows the others"), std::string::npos);
        EXPECT_NE(scene.warnings[0].find("--from"), std::string::npos);
    }
    // A floor of many squares is flat, so the number of its triangles does not matter.
    std::string grid = box;
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j)
            grid +=
                "v " + std::to_string(20 * i - 200) + " 0 " + std::to_string(20 * j - 200) + "\n";
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            const int corner = 9 + 21 * i + j; // the box has eight positions
            grid += "f " + std::to_string(corner) + " " + std::to_string(corner + 1) + " " +
                    std::to_string(corner + 22) + " " + std::to_string(corner + 21) + "\n";
        }
    EXPECT_NEAR(glm::length(load(grid).camera.position - alone.position), 0.0, 1e-9);
    // Not so much larger: the floor is part of the model.
    const Scene terrace = load(withFloor(box, 5.0, true));
    EXPECT_TRUE(terrace.warnings.empty());
    EXPECT_NEAR(reach(terrace), 0.9, 1e-6);
    // A large body with a crumb beside it, which holds fewer triangles than the body.
    const Scene crumb = load(box + "v 1.2 0 0\nv 1.3 0 0\nv 1.3 0.1 0\nf -3 -2 -1\n");
    ASSERT_EQ(crumb.warnings.size(), 1u);
    EXPECT_NE(crumb.warnings[0].find("shows all of it"), std::string::npos) << crumb.warnings[0];
    // Also where the small part is a solid.
    const Scene pebble = load(box + "v 1.2 0 0\nv 1.3 0 0\nv 1.2 0.1 0\nv 1.2 0 0.1\nf -4 -2 -3\n"
                                    "f -4 -1 -2\nf -4 -3 -1\nf -3 -2 -1\n");
    ASSERT_EQ(pebble.warnings.size(), 1u);
    EXPECT_NE(pebble.warnings[0].find("shows all of it"), std::string::npos);
    EXPECT_NEAR(reach(crumb), 0.9, 1e-6);
}

TEST_F(ModelSceneTest, IsSeenAsTheOptionsSay) {
    const std::string path = files_.write("m.obj", boxObj({-1, 0, -1}, {1, 2, 1}));
    const Scene usual = loadScene(path);
    LoadOptions options;
    options.view.from = glm::dvec3(3, 1, 0);
    const Scene from = loadScene(path, options);
    EXPECT_NEAR(glm::length(from.camera.position - glm::dvec3(3, 1, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(from.camera.forward - glm::dvec3(-1, 0, 0)), 0.0, 1e-12);
    EXPECT_NE(from.hash, usual.hash);
    options.view.lookAt = glm::dvec3(3, 1, -5);
    options.view.up = glm::dvec3(2, 0, 0);
    options.view.fov = 60.0;
    const Camera camera = loadScene(path, options)->camera;
    EXPECT_NEAR(glm::length(camera.forward - glm::dvec3(0, 0, -1)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(camera.up - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
    EXPECT_NEAR(camera.verticalFov, 3.14159265358979 / 3.0, 1e-12);
    EXPECT_NEAR(camera.focusDistance, 5.0, 1e-12);
    options.view = {};
    options.view.lookAt = glm::dvec3(0, 2, 0);
    const Camera moved = loadScene(path, options)->camera;
    EXPECT_NEAR(glm::length(moved.position - glm::dvec3(0, 2, 0)), usual.camera.focusDistance,
                1e-9);
    EXPECT_NEAR(glm::length(glm::cross(moved.forward, glm::dvec3(0, 2, 0) - moved.position)), 0.0,
                1e-9);
    options.view.from = options.view.lookAt;
    EXPECT_NE(
        std::string(errorOf([&] { loadScene(path, options); }).what()).find("must be different"),
        std::string::npos);
    options.view.lookAt.reset();
    options.view.from = glm::dvec3(0, 9, 0);
    EXPECT_NE(std::string(errorOf([&] { loadScene(path, options); }).what()).find("is parallel"),
              std::string::npos);
}

TEST_F(ModelSceneTest, UndefinedMaterialsAreGreyWithAWarning) {
    const std::string start = "mtllib none.mtl other.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
    files_.write("other.mtl", "newmtl b\nKd 0.25\n");
    const Scene scene = load(start + "f 1 2 3\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    const auto colorOf = [&](size_t triangle) {
        return scene.materials.at(modelOf(scene).triangles.at(triangle).material).color;
    };
    EXPECT_EQ(colorOf(0), glm::dvec3(0.5));
    EXPECT_EQ(colorOf(1), glm::dvec3(0.5));
    EXPECT_EQ(colorOf(2), glm::dvec3(0.25));
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_NE(scene.warnings[0].find("cannot read \"none.mtl\""), std::string::npos);
    EXPECT_NE(scene.warnings[1].find("the undefined material in \"a\""), std::string::npos);
}

TEST_F(ModelSceneTest, IsChosenByTheExtensionInAnyCase) {
    const std::string box = boxObj({0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(loadScene(files_.write("M.OBJ", box))->shapes.size(), 4u);
    EXPECT_THROW(loadScene(files_.write("m.obj.json", box)), SceneError);
}

TEST_F(ModelSceneTest, MistakesAreErrors) {
    LoadOptions options;
    options.overrides = {{"/render/spp", "4"}};
    const std::string path = files_.write("m.obj", boxObj({0, 0, 0}, {1, 1, 1}));
    const SceneError error = errorOf([&] { loadScene(path, options); });
    EXPECT_EQ(error.where(), "--set /render/spp");
    EXPECT_NE(std::string(error.what()).find("is a model"), std::string::npos);
    expectError(errorOf([&] { loadScene(files_.path("none.obj")); }), "none.obj", "cannot read");
    expectError(errorOf([&] { load("v 0 0 0\n"); }), "m.obj", "no faces");
    for (const double size : {1e-20, 1e20, 1e200})
        expectError(errorOf([&] {
                        load(boxObj({0, 0, 0}, {size, size, size}));
                    }),
                    "m.obj", "too small or too large");
}

TEST_F(ModelSceneTest, ItsHashIsThatOfItsFiles) {
    const uint64_t before = load(boxObj({0, 0, 0}, {1, 1, 1})).hash;
    EXPECT_EQ(load(boxObj({0, 0, 0}, {1, 1, 1})).hash, before);
    EXPECT_NE(load(boxObj({0, 0, 0}, {1, 1, 2})).hash, before);
}

} // namespace
} // namespace calotype::test
