// Warnings of scenes that need more than single precision: when, where and in which words.
#include "support/image_files.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

class PrecisionWarningsTest : public testing::Test {
protected:
    /// Those of a scene with a shape of the material "m", whose color is the texture "t".
    std::vector<std::string> warningsOf(const std::string& shape, const std::string& texture) {
        files_.write("two.png", pngOf({255, 255, 255, 255}));
        nlohmann::json scene = sceneWithShape(shape);
        scene["textures"]["t"] = nlohmann::json::parse(texture);
        scene["materials"]["m"] = nlohmann::json::parse(R"({"type": "diffuse", "color": "t"})");
        return ofPrecision(files_.load(scene).warnings);
    }

    static std::vector<std::string> ofPrecision(std::vector<std::string> warnings) {
        std::erase_if(warnings, [](const std::string& warning) {
            return warning.find("single precision") == std::string::npos;
        });
        return warnings;
    }

    std::vector<std::string> warningsOfQuadric(const std::string& shape) {
        return warningsOf(shape, R"({"type": "checker", "colors": [0, 1]})");
    }

    static std::string quadAt(double uv) {
        const std::string far = std::to_string(uv);
        return R"({"type": "quad", "material": "m",
                   "vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]],
                   "uvs": [[0,0],[)" +
               far + ",0],[" + far + ",1],[0,1]]}";
    }

    SceneFiles files_;
};

TEST_F(PrecisionWarningsTest, OfTexturesReadFarFromTheirOrigin) {
    const std::string image = R"({"type": "image", "file": "two.png"})";
    const auto warnings = warningsOf(quadAt(2.0 * 0x1p20), image);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("/shapes/0: textures are read up to 4.2e+06 texels from their"),
              std::string::npos)
        << warnings[0];
    EXPECT_NE(warnings[0].find("is off by up to 2 of them"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find(": \"t\""), std::string::npos) << warnings[0];
    EXPECT_TRUE(warningsOf(quadAt(100.0), image).empty());
}

TEST_F(PrecisionWarningsTest, CountTheScaleAndNotTheCheckersSize) {
    const std::string checker = R"({"type": "checker", "colors": [0, 1], "scale": [1024, 1]})";
    EXPECT_TRUE(warningsOf(quadAt(1024.0), checker).empty());
    EXPECT_EQ(warningsOf(quadAt(1025.0), checker).size(), 1u);
}

TEST_F(PrecisionWarningsTest, OfAModelFilesTexturesInOneSentence) {
    files_.write("two.png", pngOf({255, 255, 255, 255}));
    files_.write("m.mtl", "newmtl a\nmap_Kd two.png\nnewmtl b\nmap_Kd -s 3 3 3 two.png\n");
    const std::string model = files_.write("m.obj", "mtllib m.mtl\n"
                                                    "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                                    "vt 0 0\nvt 1e6 0\nvt 0 1\n"
                                                    "usemtl a\nf 1/1 2/2 3/3\n"
                                                    "usemtl b\nf 1/1 2/2 3/3\n");
    const auto warnings = ofPrecision(loadScene(model)->warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("read up to 6e+06 texels"), std::string::npos) << warnings[0];
}

TEST_F(PrecisionWarningsTest, OfWhatIsTooThin) {
    for (const char* solid :
         {R"({"type": "cylinder", "radius": 1, "height": 1e4, "material": "m"})",
          R"({"type": "cylinder", "radius": 1, "height": 1e-4, "material": "m"})",
          R"({"type": "cone", "apex": [0, 0, 0], "height": 3, "slope": 1e-4, "material": "m"})"})
        EXPECT_TRUE(warningsOfQuadric(solid).empty()) << solid;
    for (const char* thin :
         {R"({"type": "cylinder", "radius": 1, "height": 2e4, "material": "m"})",
          R"({"type": "cylinder", "radius": 1, "height": 5e-5, "material": "m"})",
          R"({"type": "cone", "apex": [0, 0, 0], "height": 3, "slope": 2e4, "material": "m"})"}) {
        const auto warnings = warningsOfQuadric(thin);
        ASSERT_EQ(warnings.size(), 1u) << thin;
        EXPECT_NE(warnings[0].find("2e+04 times larger one way than the other"), std::string::npos)
            << warnings[0];
    }
}

TEST_F(PrecisionWarningsTest, OfManyThinShapesInOneSentence) {
    nlohmann::json scene = plainScene();
    for (const double height : {1.0, 2e4, 3e5, 1e-5})
        scene["shapes"].push_back(
            {{"type", "cylinder"}, {"radius", 1}, {"height", height}, {"material", "wall"}});
    auto warnings = ofPrecision(files_.load(scene).warnings);
    std::erase_if(warnings, [](const auto& w) { return w.find("one way") == std::string::npos; });
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("/shapes/2: the cylinder is 3e+05 times larger"), std::string::npos)
        << warnings[0];
    EXPECT_NE(warnings[0].find("the most of 3 so thin"), std::string::npos) << warnings[0];
}

TEST_F(PrecisionWarningsTest, OfWhatIsSmallForItsDistance) {
    const auto cylinderAt = [](double distance, double radius, double height) {
        nlohmann::json scene = plainScene();
        scene["shapes"].push_back({{"type", "cylinder"},
                                   {"center", {0, distance, 0}},
                                   {"radius", radius},
                                   {"height", height},
                                   {"material", "wall"}});
        scene["shapes"].push_back(
            {{"type", "sphere"}, {"center", {0, 1, 4}}, {"radius", 1}, {"material", "wall"}});
        return scene;
    };
    const auto warnings = ofPrecision(files_.load(cylinderAt(1e5, 0.1, 3.0)).warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(
        warnings[0].find("/shapes/0: is only 0.2 m wide, 1e+05 m from the camera or the "
                         "scene's near side, where single precision resolves positions to 0.012 m"),
        std::string::npos)
        << warnings[0];
    EXPECT_EQ(ofPrecision(files_.load(cylinderAt(1e5, 0.75, 9.0)).warnings).size(), 1u);
    EXPECT_TRUE(ofPrecision(files_.load(cylinderAt(1e5, 0.78, 9.0)).warnings).empty());
    EXPECT_TRUE(ofPrecision(files_.load(cylinderAt(1e5, 3.0, 0.01)).warnings).empty()) << "a coin";
}

TEST_F(PrecisionWarningsTest, OfThinAndScatteredTrianglesForTheirDistance) {
    const auto warningsOfModel = [&](const std::string& vertices, const std::string& faces) {
        files_.write("m.obj", vertices + faces);
        nlohmann::json scene =
            sceneWithShape(R"({"type": "mesh", "file": "m.obj", "material": "wall"})");
        scene["shapes"].push_back(
            {{"type", "sphere"}, {"center", {0, 1, 4}}, {"radius", 1}, {"material", "wall"}});
        return ofPrecision(files_.load(scene).warnings);
    };
    const auto strip = [](double width) {
        const std::string x = std::to_string(1000.123 + width);
        return "v 1000.123 0 0\nv " + x + " 0 0\nv " + x + " 10 0\nv 1000.123 10 0\n";
    };
    const auto warnings = warningsOfModel(strip(0.0001), "f 1 2 3 4\n");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("/shapes/0: has triangles only "), std::string::npos) << warnings[0];
    EXPECT_TRUE(warningsOfModel(strip(0.1), "f 1 2 3 4\n").empty());
    EXPECT_EQ(warningsOfModel("v 1000.123 0 0\nv 1000.12314 0 0\nv 1000.123 0.0002 0\n"
                              "v 1000.123 9 0\nv 1000.12314 9 0\nv 1000.123 9.0002 0\n",
                              "f 1 2 3\nf 4 5 6\n")
                  .size(),
              1u);
}

TEST_F(PrecisionWarningsTest, OfWhatIsSmallInAnyCase) {
    const auto tiny = [](double radius) {
        return sceneWithShape(R"({"type": "sphere", "center": [0, 1, 4], "material": "wall",
                                  "radius": )" +
                              std::to_string(radius * 1e12) + "e-12}");
    };
    EXPECT_TRUE(ofPrecision(files_.load(tiny(0.51e-11)).warnings).empty());
    const auto warnings = ofPrecision(files_.load(tiny(0.49e-11)).warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(
        warnings[0].find("is only 9.8e-12 m wide; below 1e-11 m single precision may let rays"),
        std::string::npos)
        << warnings[0];
}

TEST_F(PrecisionWarningsTest, OfManySmallShapesInOneSentence) {
    nlohmann::json scene = plainScene();
    for (const double radius : {1.0, 1e-3, 1e-4, 2e-3})
        scene["shapes"].push_back({{"type", "sphere"},
                                   {"center", {0, 1e4, 0}},
                                   {"radius", radius},
                                   {"material", "wall"}});
    scene["shapes"].push_back(
        {{"type", "sphere"}, {"center", {0, 1, 4}}, {"radius", 1}, {"material", "wall"}});
    const auto warnings = ofPrecision(files_.load(scene).warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("/shapes/2: is only 0.0002 m"), std::string::npos) << warnings[0];
    EXPECT_TRUE(warnings[0].ends_with("(2 more are as small)")) << warnings[0];
}

} // namespace
} // namespace calotype::test
