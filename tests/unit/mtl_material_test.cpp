// What the materials of an MTL file become.

#include <filesystem>

#include "unit/image_files.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

class MtlMaterials : public testing::Test {
protected:
    MtlMaterials() {
        files_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                              "usemtl a\nf 1/1 2/2 3/3\n");
        files_.write("red.png", pngOf({255, 0, 0, 255}));
        files_.write("leaf.png", pngOf({0, 255, 0, 100}));
        files_.write("grey.png", pngOf({60, 60, 60, 255}));
        files_.write("normals.png", pngOf({128, 128, 255, 255}));
    }

    /// Loads a mesh whose only material has these statements.
    Scene load(const std::string& statements, const LoadOptions& options = {}) {
        files_.write("m.mtl", "newmtl a\n" + statements);
        return files_.load(sceneWithShape(R"({"type": "mesh", "file": "m.obj"})"), options);
    }

    /// Its material, where no warning but that of a black picture is due.
    Material materialOf(const std::string& statements) {
        const Scene scene = load(statements);
        for (const std::string& warning : scene.warnings)
            EXPECT_NE(warning.find("the picture will be black"), std::string::npos) << warning;
        return scene.materials.at(1);
    }

    /// Its material, where a warning that contains `remark` is due.
    Material remarkedMaterialOf(const std::string& statements, const std::string& remark) {
        const Scene scene = load(statements);
        const bool found = std::ranges::any_of(scene.warnings, [&](const std::string& warning) {
            return warning.find("m.obj: " + remark) != std::string::npos;
        });
        EXPECT_TRUE(found) << "no warning says: " << remark;
        return scene.materials.at(1);
    }

    SceneError errorOfLoading(const std::string& statements) {
        return errorOf([&] { load(statements); });
    }

    SceneFiles files_;
};

TEST_F(MtlMaterials, DiffuseByDefault) {
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

TEST_F(MtlMaterials, KeywordsCountInAnyCase) {
    EXPECT_EQ(materialOf("KD 0.25\n").color, glm::dvec3(0.25));
    EXPECT_NE(materialOf("MAP_KD red.png\n").colorTexture, Material::kNoTexture);
}

TEST_F(MtlMaterials, KeGivesEmission) {
    EXPECT_EQ(materialOf("Ke 4 3 2\n").emission, glm::dvec3(4.0, 3.0, 2.0));
}

TEST_F(MtlMaterials, KsAndNsGiveBlinnPhongThatConservesEnergy) {
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

TEST_F(MtlMaterials, PrAndPmGiveNonmetalAndMetal) {
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

TEST_F(MtlMaterials, MirrorsAreMetal) {
    const Material mirror = materialOf("Kd 0.01\nKs 0.95 0.9 0.8\nNs 1000\nillum 5\n");
    EXPECT_EQ(mirror.type, MaterialType::Metal);
    EXPECT_EQ(mirror.roughness, 0.0);
    EXPECT_EQ(mirror.color, glm::dvec3(0.95, 0.9, 0.8));
    EXPECT_EQ(materialOf("Kd 0\nKs 0.9\nillum 3\n").type, MaterialType::Metal);
    EXPECT_EQ(materialOf("Kd 0.4\nKs 0.9\nNs 9\nillum 3\n").type, MaterialType::BlinnPhong);
    EXPECT_EQ(materialOf("Kd 0\nKs 0.9\nNs 9\nillum 2\n").type, MaterialType::BlinnPhong);
}

TEST_F(MtlMaterials, GlassNeedsItsModelAndTransparency) {
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
    for (const char* ni : {"Ni 1\n", "Ni 0\n", "Ni -2\n", ""}) {
        EXPECT_EQ(remarkedMaterialOf(std::string("illum 7\nd 0.1\n") + ni, "Ni of glass").ior, 1.5);
    }
}

TEST_F(MtlMaterials, ABlackFilterIsGlass) {
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

TEST_F(MtlMaterials, DissolveGivesOpacity) {
    EXPECT_EQ(materialOf("d 0.3\n").opacity, 0.3);
    EXPECT_EQ(materialOf("d -halo 0.3\n").opacity, 0.3);
    EXPECT_EQ(materialOf("Tr 0.25\n").opacity, 0.75);
    EXPECT_EQ(materialOf("Tr 0.5\nd 0.75\n").opacity, 0.75);
    EXPECT_EQ(remarkedMaterialOf("Tr 1\n", "Tr 1 without d").opacity, 1.0);
    EXPECT_EQ(materialOf("Tr 1\nd 0\n").opacity, 0.0);
}

TEST_F(MtlMaterials, NumbersOutOfRangeAreClampedWithAWarning) {
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

TEST_F(MtlMaterials, GarbageIsAnErrorWithItsLine) {
    for (const char* statement : {"Ns x", "Ns", "d nan", "Ni inf", "Pr 0.1.2", "illum two",
                                  "Ks 1 2", "Tf spectral a.rfl", "map_Kd -bm x red.png"}) {
        EXPECT_TRUE(
            errorOfLoading(std::string("Kd 1\n") + statement + "\n").where().ends_with("/m.mtl:3"))
            << statement;
    }
}

TEST_F(MtlMaterials, MapKdColours) {
    const Scene scene = load("Kd 0.5 0.5 1\nmap_Kd -s 2 3 -o 0.5 0 -clamp on RED.png\n");
    const Material& material = scene.materials.at(1);
    EXPECT_EQ(material.color, glm::dvec3(0.5, 0.5, 1.0));
    EXPECT_EQ(material.alphaTexture, Material::kNoTexture);
    const Texture& texture = scene.textures.at(material.colorTexture);
    EXPECT_EQ(texture.scale, glm::dvec2(2.0, 3.0));
    EXPECT_EQ(texture.offset, glm::dvec2(0.5, 0.0));
    const auto& image = std::get<ImageTexture>(texture.source);
    EXPECT_EQ(image.wrap, TextureWrap::Clamp);
    EXPECT_TRUE(image.decodesColor);
    EXPECT_EQ(image.image->bytes[0], 255);
    EXPECT_EQ(materialOf("map_Kd red.png\n").color, glm::dvec3(1.0));
    EXPECT_EQ(remarkedMaterialOf("Kd 0 0 0\nmap_Kd red.png\n", "Kd 0 beside map_Kd").color,
              glm::dvec3(1.0));
}

TEST_F(MtlMaterials, EqualMapsAreOneTexture) {
    files_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\n"
                          "f 1 2 3\nusemtl c\nf 1 2 3\n");
    const Scene scene = load("map_Kd red.png\nmap_d grey.png\nnewmtl b\nmap_Kd red.png\n"
                             "map_d grey.png\nnewmtl c\nmap_Kd -s 2 2 red.png\n");
    EXPECT_EQ(scene.materials.at(1).colorTexture, scene.materials.at(2).colorTexture);
    EXPECT_EQ(scene.materials.at(1).alphaTexture, scene.materials.at(2).alphaTexture);
    EXPECT_NE(scene.materials.at(1).colorTexture, scene.materials.at(3).colorTexture);
    EXPECT_EQ(scene.textures.size(), 3u);
}

TEST_F(MtlMaterials, CutOutsComeFromMapDOrTheColoursAlpha) {
    const auto alphaOf = [&](const Scene& scene) {
        const auto& source = scene.textures.at(scene.materials.at(1).alphaTexture).source;
        return std::get<ImageTexture>(source).image->bytes.at(3);
    };
    EXPECT_EQ(alphaOf(load("map_d leaf.png\n")), 100);            // its alpha
    EXPECT_EQ(alphaOf(load("map_d grey.png\n")), 60);             // it has none: its first channel
    EXPECT_EQ(alphaOf(load("map_d -imfchan g leaf.png\n")), 255); // as asked for
    EXPECT_EQ(alphaOf(load("map_Kd leaf.png\nmap_d grey.png\n")), 60);
    const Material leaf = materialOf("map_Kd leaf.png\n");
    EXPECT_EQ(leaf.alphaTexture, leaf.colorTexture);
}

TEST_F(MtlMaterials, BumpMapsAreHeightsOrNormals) {
    const auto imageOf = [&](const std::string& statements) {
        const Scene scene = load(statements);
        const auto& source = scene.textures.at(scene.materials.at(1).normalMap).source;
        return std::get<ImageTexture>(source).image;
    };
    for (const char* keyword : {"map_Bump", "map_bump", "bump", "norm"}) {
        const auto image = imageOf(std::string(keyword) + " normals.png\n");
        ASSERT_EQ(image->bytes.size(), 16u) << keyword; // as it is
        EXPECT_EQ(image->bytes[2], 255);
        EXPECT_EQ(imageOf(std::string(keyword) + " grey.png\n")->floats.size(), 16u) << keyword;
    }
    files_.write(
        "step.png",
        pngOf(4, 1, {{0, 0, 0, 255}, {0, 0, 0, 255}, {255, 255, 255, 255}, {255, 255, 255, 255}}));
    // Half the step from the neighbours' difference, times 2: a slope of 45 degrees.
    const auto steep = imageOf("bump -bm 2 step.png\n");
    EXPECT_NEAR(steep->floats[4 * 1], 0.5 - 0.5 * std::sqrt(0.5), 1e-6);
    EXPECT_EQ(imageOf("bump -bm 2 normals.png\n")->floats.size(), 16u); // steepened
    EXPECT_EQ(imageOf("bump grey.png\nnorm normals.png\n")->bytes.size(), 16u);
}

TEST_F(MtlMaterials, MissingImages) {
    const SceneError error = errorOfLoading("Kd 1\nmap_Kd my rod.png\n");
    expectError(error, "m.mtl:3", "\"my rod.png\"");
    expectError(errorOfLoading("map_d c:\\x\\rad.png\n"), "m.mtl:2", "did you mean \"red.png\"?");
    LoadOptions options;
    options.missingTextures = MissingTextures::Warn;
    const Scene scene = load("map_Kd none.png\nmap_d none.png\nbump none.png\n", options);
    const Material& material = scene.materials.at(1);
    const auto& source = scene.textures.at(material.colorTexture).source;
    EXPECT_EQ(std::get<ImageTexture>(source).image->bytes,
              (std::vector<uint8_t>{255, 0, 255, 255}));
    EXPECT_EQ(material.alphaTexture, Material::kNoTexture);
    EXPECT_EQ(material.normalMap, Material::kNoTexture);
    EXPECT_EQ(std::ranges::count_if(scene.warnings,
                                    [](const std::string& warning) {
                                        return warning.find("there is no image file") !=
                                               std::string::npos;
                                    }),
              3);
}

TEST_F(MtlMaterials, TexturesLieBesideTheirMtl) {
    std::filesystem::create_directories(files_.path("lib"));
    files_.write("m.obj", "mtllib LIB\\m2.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    files_.write("lib/m2.mtl", "newmtl a\nmap_Kd green.png\n");
    files_.write("lib/green.png", pngOf({0, 255, 0, 255}));
    const Scene scene = load("");
    EXPECT_EQ(std::get<ImageTexture>(scene.textures.at(0).source).image->bytes[1], 255);
}

TEST_F(MtlMaterials, IgnoredOptionsAreWarnedOfOnce) {
    remarkedMaterialOf("map_Kd -mm 0 0.5 red.png\nbump -mm 0 0.5 -t 1 grey.png\n",
                       "these MTL texture options are not supported yet and were ignored: "
                       "\"-mm\", \"-t\"");
}

} // namespace
} // namespace calotype::test
