// Every key of every material, and its errors with their places.

#include "json_context_fixture.h"

namespace calotype::test {
namespace {

constexpr uint32_t kNoTexture = Material::kNoTexture;

class SceneMaterialsTest : public testing::Test, protected JsonContextFixture {
protected:
    Material read(const std::string& material) {
        readMaterialsFrom("{\"m\": " + material + "}");
        return context.scene.materials.back();
    }
};

TEST_F(SceneMaterialsTest, Metal) {
    const Material metal = read(R"({"type": "metal", "color": [1, 0.8, 0.3], "roughness": 0.25,
        "masking": "smith", "emission": 2, "emission_side": "front", "normal_map": "opaque"})");
    EXPECT_EQ(metal.type, MaterialType::Metal);
    EXPECT_EQ(metal.color, glm::dvec3(1.0, 0.8, 0.3));
    EXPECT_EQ(metal.roughness, 0.25);
    EXPECT_EQ(metal.roughnessTexture, kNoTexture);
    EXPECT_EQ(metal.masking, Masking::Smith);
    EXPECT_EQ(metal.emission, glm::dvec3(2.0));
    EXPECT_TRUE(metal.emitsFromFrontOnly);
    EXPECT_EQ(metal.normalMap, kOpaque);
    EXPECT_EQ(read(R"({"type": "metal", "color": 1, "roughness": 0})").masking, Masking::Schlick);
}

TEST_F(SceneMaterialsTest, Nonmetal) {
    const Material plain = read(R"({"type": "nonmetal", "color": 0.5, "roughness": 1})");
    EXPECT_EQ(plain.type, MaterialType::Nonmetal);
    EXPECT_EQ(plain.specular, 0.04);
    EXPECT_EQ(plain.normalMap, kNoTexture);
    const Material set = read(
        R"({"type": "nonmetal", "color": 0.5, "roughness": 1, "specular": 0.08,
            "masking": "smith"})");
    EXPECT_EQ(set.specular, 0.08);
    EXPECT_EQ(set.masking, Masking::Smith);
}

TEST_F(SceneMaterialsTest, BlinnPhong) {
    const Material paint = read(R"({"type": "blinn_phong", "color": "#ff0000", "kd": 0.75,
        "ks": 0.03125, "exponent": 1e7, "normalize": true})");
    EXPECT_EQ(paint.type, MaterialType::BlinnPhong);
    EXPECT_EQ(paint.color, glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(paint.kd, 0.75);
    EXPECT_EQ(paint.ks, 0.03125);
    EXPECT_EQ(paint.exponent, 1e7);
    EXPECT_TRUE(paint.normalize);
}

TEST_F(SceneMaterialsTest, Dielectric) {
    const Material glass = read(R"({"type": "dielectric", "ior": 1.5})");
    EXPECT_EQ(glass.type, MaterialType::Dielectric);
    EXPECT_EQ(glass.color, glm::dvec3(1.0));
    EXPECT_EQ(glass.ior, 1.5);
    EXPECT_EQ(read(R"({"type": "dielectric", "ior": 1.5, "normal_map": "opaque"})").normalMap,
              kOpaque);
    EXPECT_EQ(glass.exteriorIor, 1.0);
    const Material bubble =
        read(R"({"type": "dielectric", "ior": 1, "exterior_ior": 1.33, "color": [1, 0.5, 0.25]})");
    EXPECT_EQ(bubble.color, glm::dvec3(1.0, 0.5, 0.25));
    EXPECT_EQ(bubble.exteriorIor, 1.33);
}

TEST_F(SceneMaterialsTest, TexturesReplaceColoursAndNumbers) {
    const Material wood = read(R"({"type": "nonmetal", "color": "tiles", "roughness": "holes",
                                   "specular": "opaque"})");
    EXPECT_EQ(wood.colorTexture, kTiles);
    EXPECT_EQ(wood.color, glm::dvec3(1.0));
    EXPECT_EQ(wood.roughnessTexture, kHoles);
    EXPECT_EQ(wood.roughness, 1.0);
    EXPECT_EQ(wood.specularTexture, kOpaque);
    EXPECT_EQ(wood.specular, 1.0);
    EXPECT_EQ(wood.alphaTexture, kNoTexture); // only the colour's alpha counts
}

TEST_F(SceneMaterialsTest, TransparentColourTexturesCutHolesByDefault) {
    EXPECT_EQ(read(R"({"type": "diffuse", "color": "holes"})").alphaTexture, kHoles);
    EXPECT_EQ(read(R"({"type": "diffuse", "color": "holes", "alpha": true})").alphaTexture, kHoles);
    const Material ignoring = read(R"({"type": "diffuse", "color": "holes", "alpha": false})");
    EXPECT_EQ(ignoring.alphaTexture, kNoTexture);
    EXPECT_EQ(ignoring.colorTexture, kHoles);
    EXPECT_EQ(read(R"({"type": "diffuse", "color": "opaque"})").alphaTexture, kNoTexture);
    EXPECT_EQ(read(R"({"type": "diffuse", "color": "tiles"})").alphaTexture, kNoTexture);
}

TEST_F(SceneMaterialsTest, DisplacementsAreKeptByMaterial) {
    readMaterialsFrom(R"({"flat": {"type": "diffuse", "color": 1}, "rough": {"type": "diffuse",
        "color": 1, "displacement": {"texture": "tiles", "scale": -0.5, "mid": 0.25,
        "subdivide": 3}}, "soft": {"type": "diffuse", "color": 1,
        "displacement": {"texture": "opaque", "scale": 2}}})");
    ASSERT_EQ(context.displacements.size(), 3u);
    EXPECT_FALSE(context.displacements[0]);
    ASSERT_TRUE(context.displacements[1]);
    EXPECT_EQ(context.displacements[1]->texture, kTiles);
    EXPECT_EQ(context.displacements[1]->scale, -0.5);
    EXPECT_EQ(context.displacements[1]->mid, 0.25);
    EXPECT_EQ(context.displacements[1]->subdivide, 3u);
    ASSERT_TRUE(context.displacements[2]);
    EXPECT_EQ(context.displacements[2]->mid, 0.0);
    EXPECT_EQ(context.displacements[2]->subdivide, 0u);
}

struct BadMaterial {
    std::string material;
    std::string where; ///< below /materials/m
    std::string fragment;
};

TEST_F(SceneMaterialsTest, MistakesAreErrorsWithTheirPlaces) {
    const std::string metal = R"("type": "metal", "color": 1)";
    const std::string paint = R"("type": "blinn_phong", "color": 1, "kd": 0.5)";
    const std::string rough = metal + R"(, "roughness": 0)";
    const std::string displaced = R"("type": "diffuse", "color": 1, "displacement": )";
    const std::vector<BadMaterial> mistakes = {
        {R"("type": "metall")", "/type", "did you mean \"metal\"?"},
        {R"("type": "metal", "roughness": 1)", "", "lacks \"color\""},
        {metal, "", "lacks \"roughness\""},
        {metal + R"(, "roughness": 1.5)", "/roughness", "must be in [0, 1], not 1.5"},
        {metal + R"(, "roughness": -0.1)", "/roughness", "must be in [0, 1], not -0.1"},
        {metal + R"(, "roughness": "tile")", "/roughness", "did you mean \"tiles\"?"},
        {metal + R"(, "roughness": "#808080")", "/roughness", "must be the name of a texture"},
        {metal + R"(, "roughness": [0.5, 0.5, 0.5])", "/roughness", "a number in [0, 1] or"},
        {rough + R"(, "masking": "smiht")", "/masking", "did you mean \"smith\"?"},
        {rough + R"(, "specular": 0.5)", "/specular", "unknown key"},
        {rough + R"(, "normal_map": "tiles")", "/normal_map", "of the type \"image\""},
        {rough + R"(, "normal_map": "none")", "/normal_map", "there is no texture \"none\""},
        {rough + R"(, "normal_map": "")", "/normal_map", "must be the name of a texture"},
        {rough + R"(, "alpha": 1)", "/alpha", "must be true or false"},
        {rough + R"(, "emission": "opaque")", "/emission", "textures cannot stand here"},
        {R"("type": "diffuse", "color": "opak")", "/color", "did you mean \"opaque\"?"},
        {R"("type": "diffuse", "color": 1, "roughness": 1)", "/roughness", "unknown key"},
        {R"("type": "nonmetal", "color": 0, "roughness": 0, "specular": 2)", "/specular", "[0, 1]"},
        {paint + R"(, "exponent": 1)", "", "lacks \"ks\""},
        {paint + R"(, "ks": 0)", "", "lacks \"exponent\""},
        {paint + R"(, "ks": 1.1, "exponent": 1)", "/ks", "must be in [0, 1]"},
        {paint + R"(, "ks": "tiles", "exponent": 1)", "/ks", "must be a number"},
        {paint + R"(, "ks": 0, "exponent": -1)", "/exponent", "must be in [0, 1e+07], not -1"},
        {paint + R"(, "ks": 0, "exponent": 1.1e7)", "/exponent", "must be in [0, 1e+07]"},
        {paint + R"(, "ks": 0, "exponent": 1, "normalize": 1)", "/normalize", "true or false"},
        {paint + R"(, "ks": 0, "exponent": 1, "roughness": 1)", "/roughness", "unknown key"},
        {R"("type": "dielectric")", "", "lacks \"ior\""},
        {R"("type": "dielectric", "ior": 0)", "/ior", "in [0.01, 100], not 0"},
        {R"("type": "dielectric", "ior": 101)", "/ior", "in [0.01, 100], not 101"},
        {R"("type": "dielectric", "ior": 1, "exterior_ior": -1)", "/exterior_ior",
         "in [0.01, 100]"},
        {R"("type": "dielectric", "ior": 1, "color": "opaque")", "/color", "cannot stand here"},
        {R"("type": "dielectric", "ior": 1, "emission": 1)", "/emission", "cannot emit light"},
        {R"("type": "dielectric", "ior": 1, "emission_side": "both")", "/emission_side",
         "cannot emit light"},
        {R"("type": "dielectric", "ior": 1, "alpha": false)", "/alpha", "unknown key"},
        {R"("type": "dielectric", "ior": 1, "normal_map": "none")", "/normal_map", "no texture"},
        {displaced + "0.1", "/displacement", "must be an object"},
        {displaced + R"({"scale": 1})", "/displacement", "lacks \"texture\""},
        {displaced + R"({"texture": "tiles"})", "/displacement", "lacks \"scale\""},
        {displaced + R"({"texture": "no", "scale": 1})", "/displacement/texture", "no texture"},
        {displaced + R"({"texture": 7, "scale": 1})", "/displacement/texture", "must be a text"},
        {displaced + R"({"texture": "tiles", "scale": "1"})", "/displacement/scale", "a number"},
        {displaced + R"({"texture": "tiles", "scale": 1, "mid": []})", "/displacement/mid",
         "a number"},
        {displaced + R"({"texture": "tiles", "scale": 1, "subdivide": 13})",
         "/displacement/subdivide", "from 0 to 12, not 13"},
        {displaced + R"({"texture": "tiles", "scale": 1, "subdivide": 0.5})",
         "/displacement/subdivide", "whole number"},
        {displaced + R"({"texture": "tiles", "scale": 1, "levels": 1})", "/displacement/levels",
         "unknown key"},
    };
    for (const BadMaterial& mistake : mistakes) {
        SCOPED_TRACE(mistake.material);
        expectError(errorOf([&] { read("{" + mistake.material + "}"); }),
                    "scene.json: /materials/m" + mistake.where, mistake.fragment);
    }
}

} // namespace
} // namespace calotype::test
