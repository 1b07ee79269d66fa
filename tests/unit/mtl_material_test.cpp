// What the materials of an MTL file become.

#include "unit/mtl_fixture.h"

namespace calotype::test {
namespace {

class MtlMaterialsTest : public MtlFixture {};

TEST_F(MtlMaterialsTest, DiffuseByDefault) {
    const Material material = materialOf("Ka 1 1 1\nKd 0.1 0.2 0.3\nKs 0 0 0\nNs 10\nNi 1.45\n"
                                         "d 1\nTr 0\nTf 1 1 1\nillum 2\nKe 0 0 0\n");
    EXPECT_EQ(material.type, MaterialType::Diffuse);
    EXPECT_EQ(material.color, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(material.opacity, 1.0);
    EXPECT_EQ(material.emission, glm::dvec3(0.0));
    EXPECT_EQ(material.colorTexture, Material::kNoTexture);
    EXPECT_EQ(materialOf("").color, glm::dvec3(0.5));
    EXPECT_EQ(materialOf("Kd 0.2\nKs 1\n").type, MaterialType::Diffuse); // no Ns
    EXPECT_EQ(materialOf("Kd 0.2\nKs 1\nNs 0\n").type, MaterialType::Diffuse);
    EXPECT_EQ(materialOf("Kd 0.2\nKs 1\nNs 9\nillum 1\n").type, MaterialType::Diffuse);
}

TEST_F(MtlMaterialsTest, KeywordsCountInAnyCase) {
    EXPECT_EQ(materialOf("KD 0.25\n").color, glm::dvec3(0.25));
    EXPECT_NE(materialOf("MAP_KD red.png\n").colorTexture, Material::kNoTexture);
}

TEST_F(MtlMaterialsTest, KeGivesEmission) {
    EXPECT_EQ(materialOf("Ke 4 3 2\n").emission, glm::dvec3(4.0, 3.0, 2.0));
}

TEST_F(MtlMaterialsTest, KsAndNsGiveBlinnPhongThatConservesEnergy) {
    const Material dim = materialOf("Kd 0.5 0.25 0\nKs 0.1 0.2 0.3\nNs 40\n");
    EXPECT_EQ(dim.type, MaterialType::BlinnPhong);
    EXPECT_TRUE(dim.normalize);
    EXPECT_EQ(dim.exponent, 40.0);
    EXPECT_EQ(dim.color, glm::dvec3(0.5, 0.25, 0.0));
    EXPECT_EQ(dim.kd, 1.0);
    EXPECT_EQ(dim.ks, 0.3);
    // Kd 0.6 and Ks 0.9 reflect 1.5 of what comes; both shrink alike.
    const Material bright = materialOf("Kd 0.6\nKs 0.9\nNs 40\n");
    EXPECT_DOUBLE_EQ(bright.kd, 1.0 / 1.5);
    EXPECT_DOUBLE_EQ(bright.ks, 0.6);
    EXPECT_DOUBLE_EQ(bright.kd * 0.6 + bright.ks, 1.0);
}

TEST_F(MtlMaterialsTest, PrAndPmGiveNonmetalAndMetal) {
    const Material nonmetal = remarkedMaterialOf("Kd 0.6\nPr 0.3\nPm 0.2\nNs 9\n",
                                                 "a metallic share between 0 and 1 was rounded");
    EXPECT_EQ(nonmetal.type, MaterialType::Nonmetal);
    EXPECT_EQ(nonmetal.roughness, 0.3);
    EXPECT_EQ(nonmetal.specular, 0.04);
    EXPECT_EQ(nonmetal.masking, Masking::Schlick);
    const Material metal =
        remarkedMaterialOf("Kd 0.9 0.6 0.3\nPr 0.2\nPm 0.5\n", "a metallic share between");
    EXPECT_EQ(metal.type, MaterialType::Metal);
    EXPECT_EQ(metal.masking, Masking::Smith);
    EXPECT_EQ(metal.roughness, 0.2);
    EXPECT_EQ(metal.color, glm::dvec3(0.9, 0.6, 0.3));
    EXPECT_DOUBLE_EQ(materialOf("Pm 1\nNs 30\n").roughness, 0.5); // (2 / 32)^(1/4)
    EXPECT_EQ(materialOf("Pm 1\n").roughness, 0.5);
    const Scene mapped = load("map_Pr -imfchan g normals.png\n");
    const Material& rough = mapped.materials.at(1);
    EXPECT_EQ(rough.type, MaterialType::Nonmetal);
    EXPECT_EQ(rough.roughness, 1.0);
    EXPECT_EQ(
        std::get<ImageTexture>(mapped.textures.at(rough.roughnessTexture).source).image->bytes[0],
        128);
}

// Twice Ks times F0 = ((Ni - 1) / (Ni + 1))^2, with an index of 1.5 where there is none.
TEST_F(MtlMaterialsTest, KsBesidePrIsASpecularLevel) {
    EXPECT_NEAR(materialOf("Pr 0.3\nKs 0.5\nNi 1.5\n").specular, 0.04, 1e-15);
    EXPECT_NEAR(materialOf("Pr 0.3\nKs 0.25 0.5 0.25\nNi 2\n").specular, 1.0 / 9.0, 1e-15);
    EXPECT_NEAR(materialOf("Pr 0.3\nKs 1\nNs 9\n").specular, 0.08, 1e-15);
    EXPECT_EQ(materialOf("Pr 0.3\nKs 1\nNi 50\n").specular, 1.0);
    EXPECT_EQ(materialOf("Pr 0.3\nKs 0\nNi 1.5\n").type, MaterialType::Diffuse);
    EXPECT_EQ(materialOf("Pr 0.3\nKs 0.5\nNi 1\n").type, MaterialType::Diffuse);
}

TEST_F(MtlMaterialsTest, MapPmCountsByItsMean) {
    files_.write("half.png", pngOf(2, 1, {{204, 0, 0, 255}, {153, 0, 0, 255}})); // 0.7
    const std::string remark = "a map of the metallic share was replaced by its mean";
    EXPECT_EQ(remarkedMaterialOf("map_Pm half.png\n", remark).type, MaterialType::Metal);
    EXPECT_EQ(remarkedMaterialOf("Pm 0.8\nmap_Pm half.png\n", remark).type, MaterialType::Metal);
    EXPECT_NE(remarkedMaterialOf("Pm 0.7\nmap_Pm half.png\n", remark).type, MaterialType::Metal);
    EXPECT_NE(remarkedMaterialOf("map_Pm -imfchan g half.png\n", remark).type, MaterialType::Metal);
    LoadOptions options;
    options.missingTextures = MissingTextures::Warn;
    EXPECT_EQ(load("map_Pm none.png\n", options).materials.at(1).type, MaterialType::Diffuse);
}

TEST_F(MtlMaterialsTest, MirrorsAreMetal) {
    const Material mirror = materialOf("Kd 0.01\nKs 0.95 0.9 0.8\nNs 1000\nillum 5\n");
    EXPECT_EQ(mirror.type, MaterialType::Metal);
    EXPECT_EQ(mirror.roughness, 0.0);
    EXPECT_EQ(mirror.masking, Masking::Smith);
    EXPECT_EQ(mirror.color, glm::dvec3(0.95, 0.9, 0.8));
    EXPECT_EQ(materialOf("Kd 0\nKs 0.9\nillum 3\n").type, MaterialType::Metal);
    EXPECT_EQ(materialOf("Kd 0.4\nKs 0.9\nNs 9\nillum 3\n").type, MaterialType::BlinnPhong);
    EXPECT_EQ(materialOf("Kd 0\nKs 0.9\nNs 9\nillum 2\n").type, MaterialType::BlinnPhong);
}

TEST_F(MtlMaterialsTest, GlassNeedsItsModelAndTransparency) {
    for (const char* statements :
         {"illum 4\nd 0.2\nNi 1.33\n", "illum 6\nTr 0.5\nNi 1.33\n", "illum 7\nNi 1.33\nd 1\n",
          "illum 9\nd 0\nNi 1.33\nTf 0 0 0\n"}) {
        const Material glass = materialOf(statements);
        EXPECT_EQ(glass.type, MaterialType::Dielectric) << statements;
        EXPECT_EQ(glass.ior, 1.33);
        EXPECT_EQ(glass.color, glm::dvec3(1.0));
        EXPECT_EQ(glass.opacity, 1.0);
    }
    EXPECT_EQ(materialOf("illum 7\nNi 1.5\nTf 0.5 1 0.5\n").color, glm::dvec3(0.5, 1.0, 0.5));
    EXPECT_EQ(materialOf("illum 2\nd 0.5\nNi 1.5\n").type, MaterialType::Diffuse);
    EXPECT_EQ(materialOf("illum 4\nd 1\nNi 1\n").type, MaterialType::Diffuse);
    EXPECT_EQ(materialOf("illum 4\nNi 1.5\nKe 1\n").type, MaterialType::Diffuse);
    EXPECT_EQ(materialOf("illum 4\nNi 1.5\nmap_d leaf.png\n").type, MaterialType::Diffuse);
    for (const char* ni : {"Ni 1\n", "Ni 0\n", "Ni -2\n", ""})
        EXPECT_EQ(remarkedMaterialOf(std::string("illum 7\nd 0.1\n") + ni, "Ni of glass").ior, 1.5);
}

TEST_F(MtlMaterialsTest, ABlackFilterIsGlass) {
    const Material pane =
        remarkedMaterialOf("illum 4\nKd 0\nKs 0.1\nNs 9\nd 1\nNi 1\nTf 0.4\n", "Ni of glass");
    EXPECT_EQ(pane.type, MaterialType::Dielectric);
    EXPECT_EQ(pane.color, glm::dvec3(0.4));
    EXPECT_EQ(pane.ior, 1.5);
    for (const char* statements :
         {"illum 4\nKd 0.2\nTf 0.4\n", "illum 4\nKd 0\nTf 1\n", "illum 4\nKd 0\nTf 0\n",
          "illum 2\nKd 0\nTf 0.4\n", "illum 4\nKd 0.01\nmap_Kd red.png\nTf 0.4\n"}) {
        EXPECT_EQ(materialOf(statements).type, MaterialType::Diffuse) << statements;
    }
}

TEST_F(MtlMaterialsTest, DissolveGivesOpacity) {
    EXPECT_EQ(materialOf("d 0.3\n").opacity, 0.3);
    EXPECT_EQ(materialOf("d -halo 0.3\n").opacity, 0.3);
    EXPECT_EQ(materialOf("Tr 0.25\n").opacity, 0.75);
    EXPECT_EQ(materialOf("Tr 0.5\nd 0.75\n").opacity, 0.75);
    EXPECT_EQ(remarkedMaterialOf("Tr 1\n", "Tr 1 without d").opacity, 1.0);
    EXPECT_EQ(materialOf("Tr 1\nd 0\n").opacity, 0.0);
}

TEST_F(MtlMaterialsTest, NumbersOutOfRangeAreClampedWithAWarning) {
    EXPECT_EQ(remarkedMaterialOf("d 1.5\n", "d above 1 was lowered to 1 in \"a\"").opacity, 1.0);
    EXPECT_EQ(remarkedMaterialOf("d -1\n", "d below 0 was raised to 0 in \"a\"").opacity, 0.0);
    EXPECT_EQ(remarkedMaterialOf("Tr 2\n", "Tr above 1 was lowered to 1").opacity, 0.0);
    EXPECT_EQ(remarkedMaterialOf("Pr 3\n", "Pr above 1 was lowered to 1").roughness, 1.0);
    EXPECT_EQ(remarkedMaterialOf("Pm 2\n", "Pm above 1 was lowered to 1").type,
              MaterialType::Metal);
    EXPECT_EQ(remarkedMaterialOf("Ks 0.5\nNs 1e30\n", "Ns above ").exponent,
              Material::kHighestExponent);
    EXPECT_EQ(remarkedMaterialOf("Ks 0.5\nNs -3\n", "Ns below 0 was raised to 0").type,
              MaterialType::Diffuse);
    EXPECT_EQ(remarkedMaterialOf("Kd 2\n", "Kd above 1 was lowered to 1 in \"a\"").color,
              glm::dvec3(1.0));
    EXPECT_EQ(remarkedMaterialOf("Kd 0\nKs 3\nNs 5\n", "Ks above 1").ks, 1.0);
    EXPECT_EQ(remarkedMaterialOf("illum 7\nNi 1e9\n", "Ni above 100 was lowered to 100").ior,
              100.0);
    EXPECT_EQ(materialOf("illum 1e300\n").type, MaterialType::Diffuse);
}

TEST_F(MtlMaterialsTest, ColoursOutOfRangeAreClampedWithAWarning) {
    EXPECT_EQ(remarkedMaterialOf("Kd -0.5 0.25 3\n", "Kd below 0 was raised").color,
              glm::dvec3(0.0, 0.25, 1.0));
    EXPECT_EQ(remarkedMaterialOf("Kd 0.25\nKs -0.1 0 0\n", "Ks below 0 was raised").color,
              glm::dvec3(0.25));
    EXPECT_EQ(remarkedMaterialOf("Ke 2 -1 0\n", "Ke below 0 was raised").emission,
              glm::dvec3(2.0, 0.0, 0.0));
    EXPECT_EQ(remarkedMaterialOf("Ke 1e300\n", "Ke above 1e+30 was lowered to 1e+30").emission,
              glm::dvec3(1e30));
    EXPECT_EQ(remarkedMaterialOf("Ke 1e-40\n", "Ke, which is too small").emission, glm::dvec3(0.0));
    EXPECT_EQ(remarkedMaterialOf("illum 7\nNi 1.5\nTf -1 2 0.5\n", "Tf below 0").color,
              glm::dvec3(0.0, 1.0, 0.5));
    EXPECT_EQ(materialOf("Ka -1\n").color, glm::dvec3(0.5)); // means nothing
}

TEST_F(MtlMaterialsTest, ColoursHaveOneNumberOrThree) {
    EXPECT_EQ(materialOf("Kd 0.25\n").color, glm::dvec3(0.25));
    EXPECT_EQ(materialOf("Kd 0.125 0.25 0.5 1.0\n").color, glm::dvec3(0.125, 0.25, 0.5));
    EXPECT_EQ(materialOf("Kd 0.125 0.25 0.5 # sand\n").color, glm::dvec3(0.125, 0.25, 0.5));
    EXPECT_EQ(remarkedMaterialOf("Kd 0.125 0.25 0.5 sand\n", "statements with words").color,
              glm::dvec3(0.125, 0.25, 0.5));
}

TEST_F(MtlMaterialsTest, StatementsThatCannotBeReadAreIgnoredWithAWarning) {
    const std::string remark =
        "statements whose numbers are missing, not finite or cannot be read, "
        "which were ignored: 1 (line 3)";
    for (const char* statement : {"Kd",        "Kd 0.5 0.5",     "Kd 0.5f 0.5f 0.5f",
                                  "Kd 50%",    "Kd nan nan nan", "Kd a b c",
                                  "Ks 1 2",    "Ke inf",         "Tf x",
                                  "Ka 1 1",    "Ns x",           "Ns",
                                  "d",         "d nan",          "d -halo",
                                  "Ni inf",    "Pr 0.1.2",       "Pm 1,0",
                                  "Tr -nan",   "illum",          "illum two",
                                  "Ns -1.#IND"}) {
        SCOPED_TRACE(statement);
        const Material material =
            remarkedMaterialOf(std::string("Kd 0.25\n") + statement + "\n", remark);
        EXPECT_EQ(material.type, MaterialType::Diffuse);
        EXPECT_EQ(material.color, glm::dvec3(0.25));
        EXPECT_EQ(material.opacity, 1.0);
        EXPECT_EQ(material.emission, glm::dvec3(0.0));
    }
    for (const char* statement : {"Kd spectral a.rfl 2", "Kd xyz 0.1 0.2 0.3", "Ks SPECTRAL a.rfl"})
        EXPECT_EQ(remarkedMaterialOf(std::string("Kd 0.25\n") + statement + "\n",
                                     "spectral and CIE XYZ colours, which are not supported "
                                     "and were ignored: 1 (line 3)")
                      .color,
                  glm::dvec3(0.25));
}

TEST_F(MtlMaterialsTest, EachKindOfRemarkIsOneWarning) {
    std::string statements;
    for (int i = 0; i < 500; ++i)
        statements += "Kd\nmap_Kd\n";
    const Scene scene = load(statements);
    EXPECT_TRUE(hasWarning(scene, "which were ignored: 500 (lines 2, 4, 6, ...)"));
    EXPECT_TRUE(hasWarning(scene, "texture statements without a file name, which were ignored: "
                                  "500 (lines 3, 5, 7, ...)"));
    EXPECT_LE(scene.warnings.size(), 3u); // one is of a black picture
}

} // namespace
} // namespace calotype::test
