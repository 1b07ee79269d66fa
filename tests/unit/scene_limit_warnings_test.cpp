// Which scenes are warned of because single precision does not hold them, and which are not.

#include "unit/scene_files.h"

namespace calotype::test {
namespace {

class LimitWarningsTest : public testing::Test {
protected:
    std::vector<std::string> warningsOf(const nlohmann::json& scene, const std::string& fragment) {
        std::vector<std::string> warnings = files_.load(scene).warnings;
        std::erase_if(warnings, [&](const std::string& warning) {
            return warning.find(fragment) == std::string::npos;
        });
        return warnings;
    }

    SceneFiles files_;
};

/// A ceiling of 4 m x 4 m at y = 2, and a lamp.
nlohmann::json underCeiling(const std::string& lamp) {
    nlohmann::json scene = sceneWithShape(R"({"type": "quad", "material": "wall",
        "vertices": [[-2, 2, -2], [2, 2, -2], [2, 2, 2], [-2, 2, 2]]})");
    scene["lights"].push_back(nlohmann::json::parse(lamp));
    return scene;
}

std::string diskAt(double y, double x = 0.3, const std::string& normal = "[0, -1, 0]") {
    return R"({"type": "disk", "radiance": 1, "radius": 0.2, "center": [)" + std::to_string(x) +
           ", " + std::to_string(y) + R"(, 0.3], "normal": )" + normal + "}";
}

TEST_F(LimitWarningsTest, LampsInThePlaneOfWhatCoversThem) {
    const std::string text = "lies in the plane of";
    const auto warnings = warningsOf(underCeiling(diskAt(2.0)), text);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("/scene.json: /lights/0: lies in the plane of "), std::string::npos)
        << warnings[0];
    EXPECT_TRUE(warnings[0].ends_with("/scene.json: /shapes/0, so that rounding decides which of "
                                      "the two is seen; move it off by 4e-06 m or more"))
        << warnings[0];
    EXPECT_EQ(warningsOf(underCeiling(diskAt(2.000001)), text).size(), 1u);
    for (const char* quad : {"[[-0.5, 2, -0.5], [0.5, 2, -0.5], [0.5, 2, 0.5], [-0.5, 2, 0.5]]",
                             "[[-9, 2, -9], [9, 2, -9], [9, 2, 9], [-9, 2, 9]]"}) {
        const std::string lamp = R"({"type": "quad", "radiance": 1, "vertices": )";
        EXPECT_EQ(warningsOf(underCeiling(lamp + quad + "}"), text).size(), 1u) << quad;
    }
    EXPECT_EQ(warningsOf(underCeiling(R"({"type": "triangle", "radiance": 1,
                                          "vertices": [[0, 2, 0], [1, 2, 0], [0, 2, 1]]})"),
                         text)
                  .size(),
              1u);
}

TEST_F(LimitWarningsTest, CountLampsInsteadOfNamingAll) {
    nlohmann::json scene = underCeiling(diskAt(2.0));
    for (int i = 0; i < 30; ++i)
        scene["lights"].push_back(scene["lights"][0]);
    const auto warnings = warningsOf(scene, "lies in the plane of");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("(and 30 more of this kind, at "), std::string::npos) << warnings[0];
}

TEST_F(LimitWarningsTest, NotOfLampsApartBesideOrAcross) {
    const std::string text = "lies in the plane of";
    EXPECT_TRUE(warningsOf(underCeiling(diskAt(1.9999)), text).empty());
    EXPECT_TRUE(warningsOf(underCeiling(diskAt(2.0, 9.0)), text).empty()) << "beside it";
    EXPECT_TRUE(warningsOf(underCeiling(diskAt(2.0, 0.3, "[1, 0, 0]")), text).empty()) << "across";
    // A panel of two lamps that share an edge, each of two triangles that do.
    nlohmann::json panel = plainScene();
    for (const char* corners : {"[[0, 2, 0], [1, 2, 0], [1, 2, 1], [0, 2, 1]]",
                                "[[1, 2, 0], [2, 2, 0], [2, 2, 1], [1, 2, 1]]"})
        panel["lights"].push_back(nlohmann::json::parse(
            R"({"type": "quad", "radiance": 1, "vertices": )" + std::string(corners) + "}"));
    EXPECT_TRUE(warningsOf(panel, text).empty());
}

TEST_F(LimitWarningsTest, LampsThatCrossInOnePlane) {
    // Strips of a cross: neither holds the other's middle or corners.
    const auto strip = [](double x, double z) {
        return R"({"type": "quad", "radiance": 1, "vertices": [[)" + std::to_string(1 - x) +
               ", 2, " + std::to_string(-z) + "], [" + std::to_string(1 + x) + ", 2, " +
               std::to_string(-z) + "], [" + std::to_string(1 + x) + ", 2, " + std::to_string(z) +
               "], [" + std::to_string(1 - x) + ", 2, " + std::to_string(z) + "]]}";
    };
    nlohmann::json scene = sceneWithLight(strip(9.0, 0.1));
    scene["lights"].push_back(nlohmann::json::parse(strip(0.1, 9.0)));
    const auto isToldOfBoth = [&] {
        const auto warnings = warningsOf(scene, "lies in the plane of");
        return warnings.size() == 1 &&
               warnings[0].find("(and 1 more of this kind, at ") != std::string::npos;
    };
    EXPECT_TRUE(isToldOfBoth());
    scene["lights"][1] = nlohmann::json::parse(strip(0.1, 0.1));
    EXPECT_TRUE(isToldOfBoth());
}

TEST_F(LimitWarningsTest, CapsAndBasesInThePlaneOfACeiling) {
    const auto warningsAbout = [&](const std::string& shape) {
        nlohmann::json scene = underCeiling(diskAt(1.0));
        scene["materials"]["lamp"] = {{"type", "diffuse"}, {"color", 0}, {"emission", 1}};
        scene["shapes"].push_back(nlohmann::json::parse(shape));
        return warningsOf(scene, "/shapes/1: lies in the plane of").size();
    };
    const std::string cylinder = R"({"type": "cylinder", "material": "lamp", "radius": 0.2,
                                     "height": 1, "center": [0.3, )";
    EXPECT_EQ(warningsAbout(cylinder + "2.5, 0.3]}"), 1u) << "sunk into the ceiling";
    EXPECT_EQ(warningsAbout(cylinder + "1.5, 0.3]}"), 0u) << "hung from it, the end unseen";
    EXPECT_EQ(warningsAbout(cylinder + "2.4, 0.3]}"), 0u) << "reaching through it";
    EXPECT_EQ(warningsAbout(R"({"type": "cone", "material": "lamp", "slope": 0.5, "height": -1,
                                "apex": [0.3, 3, 0.3]})"),
              1u);
}

TEST_F(LimitWarningsTest, LampsInThePlaneOfTheirOwnMesh) {
    const auto warningsOfModel = [&](double height) {
        files_.write("room.mtl", "newmtl wall\nnewmtl lamp\nKe 1 1 1\n");
        files_.write("room.obj", "mtllib room.mtl\nv -2 2 -2\nv 2 2 -2\nv 2 2 2\nv -2 2 2\nv -1 " +
                                     std::to_string(height) + " -1\nv 1 " + std::to_string(height) +
                                     " -1\nv 1 " + std::to_string(height) +
                                     " 1\nusemtl wall\nf 1 2 3 4\nusemtl lamp\nf 5 6 7\n");
        return warningsOf(sceneWithShape(R"({"type": "mesh", "file": "room.obj"})"),
                          "lies in the plane of other triangles of its own");
    };
    EXPECT_EQ(warningsOfModel(2.0).size(), 1u);
    EXPECT_TRUE(warningsOfModel(1.9).empty());
}

TEST_F(LimitWarningsTest, LightsThatTheFilmLosesBesideTheBrightest) {
    const std::string text = "the film loses it";
    nlohmann::json scene = sceneWithLight(diskAt(2.0));
    scene["background"] = 1e-16;
    EXPECT_TRUE(warningsOf(scene, text).empty());
    scene["background"] = 1e-17;
    const auto warnings = warningsOf(scene, text);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("/scene.json: /background: shines with less than"),
              std::string::npos)
        << warnings[0];
    scene["background"] = {0, 0, 1e20};
    EXPECT_NE(warningsOf(scene, text).at(0).find("/lights/0: the material \"light 0\" shines"),
              std::string::npos);
    scene["background"] = 0;
    EXPECT_TRUE(warningsOf(scene, text).empty());
    scene["materials"]["unused"] = {{"type", "diffuse"}, {"color", 0}, {"emission", 1e20}};
    EXPECT_TRUE(warningsOf(scene, text).empty());
}

TEST_F(LimitWarningsTest, ModelsToo) {
    files_.write("model.mtl", "newmtl dim\nKe 1e-20 1e-20 1e-20\n");
    const Scene scene = loadScene(
        files_.write("model.obj", "mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl dim\n"
                                  "f 1 2 3\n"),
        {});
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find(
                  "model.obj: the material \"model.obj:dim\" shines with less than 5e-17"),
              std::string::npos);
}

TEST_F(LimitWarningsTest, ViewsFinerThanRaysAre) {
    const std::string text = "hardly resolves";
    nlohmann::json scene = sceneWithLight(diskAt(2.0));
    scene["film"] = {{"width", 1000}, {"height", 500}};
    auto& camera = scene["camera"];
    camera["fov"] = 0.028; // 0.98e-6 rad a pixel
    EXPECT_TRUE(warningsOf(scene, text).empty()) << "along an axis";
    camera["target"] = {1, 1, 0};
    const auto warnings = warningsOf(scene, text);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("/scene.json: /camera/fov: is so narrow"), std::string::npos);
    camera["fov"] = 0.029;
    EXPECT_TRUE(warningsOf(scene, text).empty());

    camera.erase("fov");
    camera["type"] = "orthographic";
    camera["height"] = 1.8e-3; // 3.6e-6 m a pixel; the lamp is 3.64 m away
    EXPECT_NE(warningsOf(scene, text).at(0).find("/camera/height: makes pixels smaller"),
              std::string::npos);
    camera["height"] = 1.85e-3;
    EXPECT_TRUE(warningsOf(scene, text).empty());
    camera["height"] = 1e-3;
    camera["position"] = {0.25, 2, 0.35}; // within the lamp's bounds
    EXPECT_TRUE(warningsOf(scene, text).empty());
}

TEST_F(LimitWarningsTest, ViewsFinerThanRaysAreInTheSizeThatIsRendered) {
    nlohmann::json scene = sceneWithLight(diskAt(2.0));
    scene["camera"]["target"] = {1, 1, 0};
    scene["camera"]["fov"] = 0.028;
    scene["film"] = {{"width", 100}, {"height", 100}};
    const auto isWarnedOf = [&](const LoadOptions& options) {
        return !files_.load(scene, options).warnings.empty();
    };
    EXPECT_FALSE(isWarnedOf({}));
    LoadOptions larger;
    larger.size = PictureSize{100, 500};
    EXPECT_TRUE(isWarnedOf(larger));
}

TEST_F(LimitWarningsTest, LensesManyTimesWiderThanTheirFocusIsFar) {
    const std::string text = "/camera/lens_radius: is more than 100 times the focus_distance";
    nlohmann::json scene = sceneWithLight(diskAt(2.0));
    scene["camera"]["target"] = {1, 1, 0};
    scene["camera"]["focus_distance"] = 0.1;
    scene["camera"]["lens_radius"] = 10.1;
    EXPECT_EQ(warningsOf(scene, text).size(), 1u);
    scene["camera"]["lens_radius"] = 10;
    EXPECT_TRUE(warningsOf(scene, text).empty());
}

} // namespace
} // namespace calotype::test
