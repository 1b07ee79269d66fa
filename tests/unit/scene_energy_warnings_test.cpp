// When a scene's materials are said to reflect more than they receive, where and in which words.

#include <algorithm>

#include "support/image_files.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

class EnergyWarningsTest : public testing::Test {
protected:
    EnergyWarningsTest() {
        files_.write("white.png", pngOf({255, 255, 255, 255}));
        files_.write("dark.png", pngOf({40, 40, 40, 255}));
    }

    /// Those of a scene with textures "white" and "dark", and a ball of the material "m".
    std::vector<std::string> warningsOf(const std::string& material, bool isBorne = true) {
        nlohmann::json scene =
            isBorne ? sceneWithShape(R"({"type": "sphere", "radius": 1, "material": "m"})")
                    : plainScene();
        scene["textures"] = nlohmann::json::parse(
            R"({"white": {"type": "image", "file": "white.png"},
                "dark": {"type": "image", "file": "dark.png"}})");
        scene["materials"]["m"] = nlohmann::json::parse(material);
        return energyWarnings(files_.load(scene));
    }

    /// Those of a mesh whose MTL file has these materials, "a" to "c".
    std::vector<std::string> warningsOfMtl(const std::string& mtl) {
        writeObj(mtl);
        return energyWarnings(files_.load(sceneWithShape(R"({"type": "mesh", "file": "m.obj"})")));
    }

    void writeObj(const std::string& mtl) {
        files_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                              "usemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n"
                              "usemtl c\nf 1/1 2/1 3/1\n");
        files_.write("m.mtl", mtl);
    }

    static std::vector<std::string> energyWarnings(const Scene& scene) {
        std::vector<std::string> warnings = scene.warnings;
        std::erase_if(warnings, [](const std::string& warning) {
            return warning.find("reflect") == std::string::npos;
        });
        return warnings;
    }

    static void expectOne(const std::vector<std::string>& warnings, const std::string& end) {
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_TRUE(warnings[0].ends_with(end)) << warnings[0];
    }

    SceneFiles files_;
};

TEST_F(EnergyWarningsTest, OfConstantMaterialsNameTheirPlace) {
    expectOne(warningsOf(R"({"type": "blinn_phong", "color": 0, "kd": 0.7, "ks": 0.1,
                             "exponent": 9})"),
              "/scene.json: /materials/m: this blinn_phong can reflect more light than it "
              "receives, since kd + 4 ks > 1; lower kd or ks, or set \"normalize\": true");
    expectOne(warningsOf(R"({"type": "blinn_phong", "color": 1, "kd": 0.75, "ks": 0.5,
                             "exponent": 9, "normalize": true})"),
              "/scene.json: /materials/m: this blinn_phong can reflect up to 125.0 % of the light "
              "that it receives; lower kd or ks");
    expectOne(warningsOf(R"({"type": "nonmetal", "color": 0.89, "roughness": 0})"),
              "/scene.json: /materials/m: this nonmetal reflects up to 101.4 % of the light that "
              "it receives, at grazing angles; choose a darker colour");
    EXPECT_TRUE(warningsOf(R"({"type": "nonmetal", "color": 0.8, "roughness": 0})").empty());
}

TEST_F(EnergyWarningsTest, OfTexturedMaterialsSayCan) {
    expectOne(warningsOf(R"({"type": "nonmetal", "color": "white", "roughness": 0.5})"),
              " % of the light that it receives, at grazing angles; choose a darker colour");
    const std::string rough =
        warningsOf(R"({"type": "nonmetal", "color": 0.95, "roughness": "dark"})").at(0);
    EXPECT_NE(rough.find("this nonmetal can reflect up to 10"), std::string::npos) << rough;
    expectOne(warningsOf(R"({"type": "blinn_phong", "color": "white", "kd": 0.75, "ks": 0.125,
                             "exponent": 9})"),
              "this blinn_phong can reflect up to 125.0 % of the light that it receives; lower kd "
              "or ks, or set \"normalize\": true");
    for (const char* material :
         {R"({"type": "nonmetal", "color": "dark", "roughness": 0})",
          R"({"type": "nonmetal", "color": 0.95, "roughness": "white"})",
          R"({"type": "blinn_phong", "color": "dark", "kd": 0.75, "ks": 0.125, "exponent": 9})"})
        EXPECT_TRUE(warningsOf(material).empty()) << material;
}

TEST_F(EnergyWarningsTest, OmitMaterialsThatNoShapeUses) {
    const std::string white = R"({"type": "nonmetal", "color": 1, "roughness": 0})";
    EXPECT_TRUE(warningsOf(white, false).empty());
    EXPECT_EQ(warningsOf(white, true).size(), 1u);
}

TEST_F(EnergyWarningsTest, OfMtlFilesAreOne) {
    const std::string mtl = "newmtl a\nKd 1\nPr 0\nnewmtl b\nKd 0.5\nPr 0\n"
                            "newmtl c\nmap_Kd white.png\nPr 0\n";
    expectOne(warningsOfMtl(mtl), "/m.obj: materials that can reflect more light than they "
                                  "receive, up to 112.0 % at grazing angles (choose darker "
                                  "colours or a greater roughness): \"m.obj:a\", \"m.obj:c\"");
    EXPECT_TRUE(warningsOfMtl("newmtl a\nKd 0.5\nPr 0\nnewmtl b\nKd 1\nKs 1\nNs 9\n"
                              "newmtl c\nmap_Kd dark.png\nPr 0\n")
                    .empty());
}

TEST_F(EnergyWarningsTest, OfBareModelsToo) {
    writeObj("newmtl a\nKd 0.5\nnewmtl b\nKd 0.5\nnewmtl c\nKd 1\nPr 0\n");
    expectOne(energyWarnings(loadScene(files_.path("m.obj"))), "roughness): \"m.obj:c\"");
}

} // namespace
} // namespace calotype::test
