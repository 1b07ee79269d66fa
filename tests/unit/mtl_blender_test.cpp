// MTL files that Blender writes, and what its materials become.

#include <cmath>

#include "reference/bsdf.h"
#include "support/test_materials.h"
#include "unit/mtl_fixture.h"

namespace calotype::test {
namespace {

class MtlBlenderTest : public MtlFixture {
protected:
    MtlBlenderTest() {
        firstLine_ = "# Blender 5.0.1 MTL File: 'None'\n# www.blender.org\n\n";
        files_.write("low.png", pngOf({51, 51, 51, 255}));     // 0.2
        files_.write("high.png", pngOf({204, 204, 204, 255})); // 0.8
    }

    /// A material of the default option.
    static std::string plain(double exponent, const std::string& kd, const std::string& more = "") {
        return "Ns " + std::to_string(exponent) + "\nKa 1 1 1\nKd " + kd +
               "\nKs 0.5 0.5 0.5\nKe 0 0 0\nNi 1.5\nd 1\nillum 2\n" + more;
    }

    /// One of the PBR option.
    static std::string pbr(const std::string& more) {
        return "Kd 0.16 0.0625 0.25\nKs 0.5 0.5 0.5\nKe 0 0 0\nNi 1.5\nd 1\nillum 2\nPr 0.25\nPm "
               "0\n"
               "Ps 0\nPc 0\nPcr 0.03\naniso 0\nanisor 0.25\n" +
               more;
    }
};

/// The mean radiance of a ball of the material under light of radiance 1 from everywhere, red.
double whiteFurnace(const Material& material) {
    constexpr int kCosines = 32;
    constexpr int kSteps = 12;
    reference::Surface surface{};
    surface.ng = surface.ns = surface.horizon = {0.0, 0.0, 1.0};
    double sum = 0.0;
    for (int c = 0; c < kCosines; ++c) {
        const double cosTheta = (c + 0.5) / kCosines;
        const reference::Bsdf bsdf(material, {}, surface, directionAt(cosTheta, 0.0));
        for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
            const glm::dvec3 cell(i % kSteps, i / kSteps % kSteps, i / (kSteps * kSteps));
            sum += 2.0 * cosTheta * bsdf.sample((cell + 0.5) / double{kSteps}).weight.x;
        }
    }
    return sum / (kCosines * std::pow(kSteps, 3));
}

TEST_F(MtlBlenderTest, ItsDefaultOptionStatesRoughnessByNs) {
    for (const double roughness : {0.0, 0.25, 0.5, 1.0}) {
        const double exponent = 1000.0 * (1.0 - roughness) * (1.0 - roughness);
        const Material material = materialOf(plain(exponent, "0.2 0.1 0.05"));
        EXPECT_EQ(material.type, MaterialType::Nonmetal);
        EXPECT_NEAR(material.roughness, roughness, 1e-8); // six decimals of Ns
        EXPECT_NEAR(material.specular, 0.04, 1e-15);
        EXPECT_EQ(material.masking, Masking::Smith);
        EXPECT_EQ(material.color, glm::dvec3(0.2, 0.1, 0.05));
        EXPECT_EQ(material.opacity, 1.0);
    }
    EXPECT_EQ(remarkedMaterialOf(plain(4000, "0.1"), "Ns above 1000 was lowered to 1000").roughness,
              0.0);
    EXPECT_EQ(remarkedMaterialOf(plain(-1, "0.1"), "Ns below 0 was raised to 0").roughness, 1.0);
    const Scene mapped = load("Ka 1 1 1\nKd 0.1 0.1 0.1\nKs 0.5 0.5 0.5\nNi 1.5\nillum 2\n"
                              "map_Ns high.png\n");
    const Material& rough = mapped.materials.at(1);
    EXPECT_EQ(rough.type, MaterialType::Nonmetal);
    EXPECT_EQ(rough.roughness, 1.0);
    const auto& source = mapped.textures.at(rough.roughnessTexture).source;
    EXPECT_EQ(std::get<ImageTexture>(source).image->bytes[0], 204);
    // Before 3.1 it also wrote the number that the map replaces.
    EXPECT_EQ(materialOf(plain(250, "0.1 0.1 0.1", "map_Ns high.png\n")).roughness, 1.0);
}

TEST_F(MtlBlenderTest, ItsFilesAreKnownByTheirFirstLine) {
    const std::string statements = plain(250, "0.1 0.1 0.1");
    for (const char* line :
         {"# Blender MTL File: 'None'\n# Material Count: 1\n",
          "\xEF\xBB\xBF# Blender 4.2.3 LTS MTL File: 'a.blend'\r\n", "#Blender 3.6 MTL File\r"}) {
        firstLine_ = line;
        EXPECT_EQ(materialOf(statements).type, MaterialType::Nonmetal) << line;
    }
    for (const char* line : {"", "# made for Blender\n", "# Exporter\n# Blender 4.2 MTL File\n"}) {
        firstLine_ = line;
        const Material other = materialOf(statements);
        EXPECT_EQ(other.type, MaterialType::BlinnPhong) << line;
        EXPECT_EQ(other.exponent, 250.0);
    }
}

TEST_F(MtlBlenderTest, ColouredHighlightsAreOfAnotherOrigin) {
    EXPECT_EQ(materialOf("Ns 90\nKa 0 0 0\nKd 0.2 0.2 0.2\nKs 0.5 0.1 0.1\nillum 2\n").type,
              MaterialType::BlinnPhong);
    EXPECT_EQ(
        remarkedMaterialOf(
            "Ns 90\nKd 0.2\nKs 0.5 0.1 0.1\nmap_Ks low.png\n",
            "map_Ns, map_Ks and map_refl were ignored, because Ks or Ka is not grey, in \"a\"")
            .type,
        MaterialType::BlinnPhong);
}

TEST_F(MtlBlenderTest, KsIsTheSpecularLevel) {
    EXPECT_NEAR(materialOf("Ns 250\nKd 0.1\nKs 1 1 1\nNi 2\n").specular, 2.0 / 9.0, 1e-15);
    EXPECT_EQ(materialOf("Ns 250\nKd 0.1\nKs 0 0 0\nNi 1.5\nillum 1\n").type,
              MaterialType::Diffuse);
    const Scene mapped = load("Ns 250\nKd 0.1\nNi 1.5\nillum 2\nmap_Ks low.png\n");
    const Material& material = mapped.materials.at(1);
    EXPECT_NEAR(material.specular, 0.08, 1e-15);
    const auto& source = mapped.textures.at(material.specularTexture).source;
    EXPECT_EQ(std::get<ImageTexture>(source).image->bytes[0], 51);
}

TEST_F(MtlBlenderTest, IllumAndKaMarkMetals) {
    const std::string start = "Ns 490\nKd 1 0.77 0.34\nKs 0.5 0.5 0.5\nNi 1.5\n";
    for (const char* model : {"3", "6"}) {
        const Material gold = materialOf(start + "Ka 1 1 1\nillum " + model + "\n");
        EXPECT_EQ(gold.type, MaterialType::Metal);
        EXPECT_EQ(gold.color, glm::dvec3(1.0, 0.77, 0.34));
        EXPECT_NEAR(gold.roughness, 0.3, 1e-15);
        EXPECT_EQ(gold.masking, Masking::Smith);
    }
    const std::string rounded = "a metallic share between 0 and 1 was rounded";
    EXPECT_EQ(remarkedMaterialOf(start + "Ka 0.5 0.5 0.5\nillum 3\n", rounded).type,
              MaterialType::Metal);
    EXPECT_EQ(remarkedMaterialOf(start + "Ka 0.4 0.4 0.4\nillum 3\n", rounded).type,
              MaterialType::Nonmetal);
    // Black with a highlight is a mirror elsewhere.
    EXPECT_EQ(remarkedMaterialOf("Ns 490\nKa 0.2\nKd 0\nKs 0.5\nNi 1.5\nillum 3\n", rounded).type,
              MaterialType::Nonmetal);
    const std::string mean = "a map of the metallic share was replaced by its mean";
    EXPECT_EQ(remarkedMaterialOf(start + "Ka 1 1 1\nillum 2\nmap_refl high.png\n", mean).type,
              MaterialType::Metal);
    EXPECT_EQ(remarkedMaterialOf(start + "Ka 1 1 1\nillum 2\nrefl high.png\n", mean).type,
              MaterialType::Metal);
    EXPECT_EQ(remarkedMaterialOf(start + "Ka 1 1 1\nillum 2\nmap_refl low.png\n", mean).type,
              MaterialType::Nonmetal);
}

// In balls under light from everywhere. Cycles 5.0.1 shows 0.102 for the dark one. GGX without
// light of several bounces keeps 98 % in a mirror of roughness 0.3.
TEST_F(MtlBlenderTest, WhiteFurnacesAreThoseOfCycles) {
    EXPECT_NEAR(whiteFurnace(materialOf(plain(250, "0.05 0.05 0.05"))), 0.102, 0.02 * 0.102);
    const std::string metal = "Kd 1 0.77 0.34\nKa 1 1 1\nKs 0.5 0.5 0.5\nillum 3\nNs ";
    EXPECT_NEAR(whiteFurnace(materialOf(metal + "490\n")), 0.98, 0.01);
    EXPECT_NEAR(whiteFurnace(materialOf(metal + "1000\n")), 1.0, 1e-3); // a perfect mirror
}

TEST_F(MtlBlenderTest, AlphaIsOpacity) {
    const Material thin = materialOf("Ns 250\nKa 1 1 1\nKd 0.1 0.1 0.1\nKs 0.5 0.5 0.5\nNi 1.45\n"
                                     "d 0.5\nillum 9\n");
    EXPECT_EQ(thin.type, MaterialType::Nonmetal);
    EXPECT_EQ(thin.opacity, 0.5);
    EXPECT_EQ(materialOf("Ns 250\nKa 1\nKd 0.8\nKs 0.5\nNi 1.45\nd 0.5\nillum 6\n").type,
              MaterialType::Metal);
    EXPECT_EQ(materialOf(pbr("d 0.25\nillum 9\n")).opacity, 0.25);
    firstLine_.clear(); // others mean glass
    EXPECT_EQ(materialOf("Ns 250\nKd 0.8\nKs 0.5\nNi 1.45\nd 0.5\nillum 9\n").type,
              MaterialType::Dielectric);
}

TEST_F(MtlBlenderTest, ItsPbrOptionStatesTransmissionByTf) {
    const Material glass = remarkedMaterialOf(pbr("Tf 1 1 1\n"), "the roughness of glass");
    EXPECT_EQ(glass.type, MaterialType::Dielectric);
    EXPECT_EQ(glass.ior, 1.5);
    EXPECT_EQ(glass.color, glm::dvec3(0.4, 0.25, 0.5)); // its square is Kd, behind two crossings
    EXPECT_EQ(materialOf(pbr("Pr 0\nTf 0.6 0.6 0.6\n")).type, MaterialType::Dielectric);
    const std::string ignored = "transmission (Tf) of at most 0.5";
    for (const char* more :
         {"Tf 0.5 0.5 0.5\n", "Tf 1 1 1\nKe 1 1 1\n", "Tf 1 1 1\nmap_d leaf.png\n"})
        EXPECT_EQ(remarkedMaterialOf(pbr(more), ignored).type, MaterialType::Nonmetal) << more;
    EXPECT_EQ(materialOf(pbr("Pm 1\nTf 1 1 1\n")).type, MaterialType::Metal);
    firstLine_.clear(); // elsewhere it is a filter, which 1 leaves out
    EXPECT_EQ(materialOf(pbr("Tf 1 1 1\n")).type, MaterialType::Nonmetal);
}

TEST_F(MtlBlenderTest, ItsPbrOptionStatesRoughnessAndMetals) {
    const Material nonmetal = materialOf(pbr(""));
    EXPECT_EQ(nonmetal.type, MaterialType::Nonmetal);
    EXPECT_EQ(nonmetal.roughness, 0.25);
    EXPECT_NEAR(nonmetal.specular, 0.04, 1e-15);
    EXPECT_EQ(nonmetal.masking, Masking::Smith);
    const Material metal = materialOf(pbr("Pm 1\nillum 3\n"));
    EXPECT_EQ(metal.type, MaterialType::Metal);
    EXPECT_EQ(metal.roughness, 0.25);
}

TEST_F(MtlBlenderTest, AFieldWithoutEffectGivesNoWarning) {
    materialOf(pbr("")); // its Pc and aniso are 0, so Pcr and anisor have no effect
    remarkedMaterialOf(pbr("Pc 2\n"), "these MTL statements are not supported and were ignored: "
                                      "\"Pc\", \"Pcr\"");
    remarkedMaterialOf(pbr("aniso 0.5\n"), "these MTL statements are not supported and were "
                                           "ignored: \"aniso\", \"anisor\"");
}

} // namespace
} // namespace calotype::test
