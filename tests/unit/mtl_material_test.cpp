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
    const Material nonmetal = materialOf("Kd 0.6\nPr 0.3\nPm 0.2\nKs 1\nNs 9\n");
    EXPECT_EQ(nonmetal.type, MaterialType::Nonmetal);
    EXPECT_EQ(nonmetal.roughness, 0.3);
    EXPECT_EQ(nonmetal.specular, 0.04);
    const Material metal = materialOf("Kd 0.9 0.6 0.3\nPr 0.2\nPm 0.5\n");
    EXPECT_EQ(metal.type, MaterialType::Metal);
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

TEST_F(MtlMaterialsTest, MirrorsAreMetal) {
    const Material mirror = materialOf("Kd 0.01\nKs 0.95 0.9 0.8\nNs 1000\nillum 5\n");
    EXPECT_EQ(mirror.type, MaterialType::Metal);
    EXPECT_EQ(mirror.roughness, 0.0);
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
    EXPECT_EQ(remarkedMaterialOf("d 1.5\n", "d was lowered").opacity, 1.0);
    EXPECT_EQ(remarkedMaterialOf("d -1\n", "d was raised").opacity, 0.0);
    EXPECT_EQ(remarkedMaterialOf("Tr 2\n", "Tr was lowered").opacity, 0.0);
    EXPECT_EQ(remarkedMaterialOf("Pr 3\n", "Pr was lowered").roughness, 1.0);
    EXPECT_EQ(remarkedMaterialOf("Pm 2\n", "Pm was lowered").type, MaterialType::Metal);
    EXPECT_EQ(remarkedMaterialOf("Ks 0.5\nNs 1e30\n", "Ns was lowered").exponent,
              Material::kHighestExponent);
    EXPECT_EQ(remarkedMaterialOf("Ks 0.5\nNs -3\n", "Ns was raised").type, MaterialType::Diffuse);
    EXPECT_EQ(remarkedMaterialOf("Kd 2\n", "Kd above 1 was lowered to 1 in \"a\"").color,
              glm::dvec3(1.0));
    EXPECT_EQ(remarkedMaterialOf("Kd 0\nKs 3\nNs 5\n", "Ks above 1").ks, 1.0);
    EXPECT_EQ(remarkedMaterialOf("illum 7\nNi 1e9\n", "Ni was lowered").ior, 100.0);
    EXPECT_EQ(materialOf("illum 1e300\n").type, MaterialType::Diffuse);
}

TEST_F(MtlMaterialsTest, GarbageIsAnErrorWithItsLine) {
    for (const char* statement : {"Ns x", "Ns", "d nan", "Ni inf", "Pr 0.1.2", "illum two",
                                  "Ks 1 2", "Tf spectral a.rfl", "map_Kd -bm x red.png"}) {
        EXPECT_TRUE(
            errorOfLoading(std::string("Kd 1\n") + statement + "\n").where().ends_with("/m.mtl:3"))
            << statement;
    }
}

} // namespace
} // namespace calotype::test
