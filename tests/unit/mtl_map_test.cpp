// What the textures of an MTL file do.

#include <cmath>
#include <filesystem>

#include "unit/mtl_fixture.h"

namespace calotype::test {
namespace {

class MtlMapsTest : public MtlFixture {};

TEST_F(MtlMapsTest, MapKdColours) {
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

TEST_F(MtlMapsTest, EqualMapsAreOneTexture) {
    files_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\n"
                          "f 1 2 3\nusemtl c\nf 1 2 3\n");
    const Scene scene = load("map_Kd red.png\nmap_d grey.png\nnewmtl b\nmap_Kd red.png\n"
                             "map_d grey.png\nnewmtl c\nmap_Kd -s 2 2 red.png\n");
    EXPECT_EQ(scene.materials.at(1).colorTexture, scene.materials.at(2).colorTexture);
    EXPECT_EQ(scene.materials.at(1).alphaTexture, scene.materials.at(2).alphaTexture);
    EXPECT_NE(scene.materials.at(1).colorTexture, scene.materials.at(3).colorTexture);
    EXPECT_EQ(scene.textures.size(), 3u);
}

TEST_F(MtlMapsTest, CutOutsComeFromMapDOrTheColoursAlpha) {
    const auto alphaOf = [&](const Scene& scene) {
        const auto& source = scene.textures.at(scene.materials.at(1).alphaTexture).source;
        return std::get<ImageTexture>(source).image->bytes.at(3);
    };
    EXPECT_EQ(alphaOf(load("map_d leaf.png\n")), 100);            // its alpha
    EXPECT_EQ(alphaOf(load("map_d grey.png\n")), 60);             // it has none: its first channel
    EXPECT_EQ(alphaOf(load("map_d -imfchan g leaf.png\n")), 255); // as -imfchan says
    EXPECT_EQ(alphaOf(load("map_Kd leaf.png\nmap_d grey.png\n")), 60);
    const Material leaf = materialOf("map_Kd leaf.png\n");
    EXPECT_EQ(leaf.alphaTexture, leaf.colorTexture);
}

TEST_F(MtlMapsTest, BumpMapsAreHeightsOrNormals) {
    const auto imageOf = [&](const std::string& statements) {
        const Scene scene = load(statements);
        const auto& source = scene.textures.at(scene.materials.at(1).normalMap).source;
        return std::get<ImageTexture>(source).image;
    };
    for (const char* keyword : {"map_Bump", "map_bump", "bump", "norm"}) {
        const auto image = imageOf(std::string(keyword) + " normals.png\n");
        ASSERT_EQ(image->bytes.size(), 16u) << keyword; // as it is
        EXPECT_EQ(image->bytes[2], 255);
    }
    for (const char* keyword : {"map_Bump", "map_bump", "bump"})
        EXPECT_EQ(imageOf(std::string(keyword) + " grey.png\n")->floats.size(), 16u) << keyword;
    EXPECT_EQ(imageOf("norm grey.png\n")->bytes[0], 60); // always as it is
    EXPECT_EQ(imageOf("norm red.png\n")->bytes[0], 255);
    files_.write(
        "step.png",
        pngOf(4, 1, {{0, 0, 0, 255}, {0, 0, 0, 255}, {255, 255, 255, 255}, {255, 255, 255, 255}}));
    // Half the step from the neighbours' difference, times 2: a slope of 45 degrees.
    const auto steep = imageOf("bump -bm 2 step.png\n");
    EXPECT_NEAR(steep->floats[4 * 1], 0.5 - 0.5 * std::sqrt(0.5), 1e-6);
    EXPECT_EQ(imageOf("bump -bm 2 normals.png\n")->floats.size(), 16u); // steepened
    EXPECT_EQ(imageOf("bump grey.png\nnorm normals.png\n")->bytes.size(), 16u);
}

// Photographs are often named as bump maps. Their heights are their luminance, of which green has a
// share of 0.7152 (ITU-R BT.709).
TEST_F(MtlMapsTest, ColouredBumpMapsThatCannotBeNormalsAreHeights) {
    files_.write(
        "brick.png",
        pngOf(4, 1, {{200, 0, 0, 255}, {200, 0, 0, 255}, {200, 255, 0, 255}, {200, 255, 0, 255}}));
    const std::string remark = "a coloured picture of bump, which does not look like a normal map, "
                               "was read as heights in \"a\"";
    const Scene scene = load("bump -bm 2 brick.png\n");
    EXPECT_TRUE(hasWarning(scene, remark));
    const auto imageOf = [](const Scene& of) {
        const auto& source = of.textures.at(of.materials.at(1).normalMap).source;
        return std::get<ImageTexture>(source).image;
    };
    const double x = 2.0 * imageOf(scene)->floats[4 * 1] - 1.0;
    EXPECT_NEAR(x, -0.7152 / std::sqrt(1.0 + 0.7152 * 0.7152), 1e-6);
    // One channel, where the statement names it.
    const auto red = imageOf(load("bump -bm 2 -imfchan r brick.png\n"));
    EXPECT_NEAR(red->floats[4 * 1], 0.5, 1e-6);
}

TEST_F(MtlMapsTest, OptionsOutOfRangeOrUnreadableDoNotStopTheModel) {
    remarkedMaterialOf("map_Kd -s 1e30 red.png\n",
                       "texture statements with numbers out of range, which were limited: 1");
    const Material bad =
        remarkedMaterialOf("Kd 0.25\nmap_Kd -bm x red.png\n",
                           "texture statements whose options cannot be read, which were ignored: "
                           "1 (line 3)");
    EXPECT_EQ(bad.colorTexture, Material::kNoTexture);
    EXPECT_EQ(bad.color, glm::dvec3(0.25));
    EXPECT_EQ(remarkedMaterialOf("Kd 0.25\nmap_Kd\n", "texture statements without a file name")
                  .colorTexture,
              Material::kNoTexture);
    files_.write("noise.png", pngOf(3, 1, {{0, 0, 0, 255}, {9, 9, 9, 255}, {90, 90, 90, 255}}));
    for (const char* factor : {"1e300", "-1e300"}) {
        const Scene steep = load(std::string("bump -bm ") + factor + " noise.png\n");
        const auto& source = steep.textures.at(steep.materials.at(1).normalMap).source;
        const auto& floats = std::get<ImageTexture>(source).image->floats;
        EXPECT_NEAR(std::abs(2.0 * floats[0] - 1.0), 1.0, 1e-6); // nearly along the surface
    }
}

// A '#' after a blank starts a comment unless it belongs to the name of a file.
TEST_F(MtlMapsTest, CommentsBehindNamesAreLeftOut) {
    files_.write("wood #2.png", pngOf({0, 0, 255, 255}));
    const auto firstTexel = [&](const std::string& statements) {
        const Scene scene = load(statements);
        const auto& source = scene.textures.at(scene.materials.at(1).colorTexture).source;
        const auto& bytes = std::get<ImageTexture>(source).image->bytes;
        return glm::dvec3(bytes[0], bytes[1], bytes[2]);
    };
    const glm::dvec3 red(255.0, 0.0, 0.0);
    const glm::dvec3 blue(0.0, 0.0, 255.0);
    for (const char* name :
         {"red.png", "red.png # the best", "red.png #best", "red.png\t#", "\"red.png\" # quoted",
          "red.png\t", "red.png -bm 2 # steep", "-bm 1 red.png #2 of 3.png"})
        EXPECT_EQ(firstTexel(std::string("map_Kd ") + name + "\n"), red) << name;
    for (const char* name : {"wood #2.png", "wood #2.png # the best", "\"wood #2.png\"",
                             "-s 1 1 wood #2.png", "wood #2.png\r"})
        EXPECT_EQ(firstTexel(std::string("map_Kd ") + name + "\n"), blue) << name;
    expectError(errorOfLoading("map_Kd rad.png # a colour\n"), "m.mtl:2", "file \"rad.png\"");
    expectError(errorOfLoading("map_Kd steel #2.png\n"), "m.mtl:2", "file \"steel #2.png\"");
}

TEST_F(MtlMapsTest, MapKeMultipliesKeByItsMean) {
    files_.write("screen.png", pngOf(2, 1, {{255, 128, 0, 255}, {0, 128, 0, 255}}));
    const std::string remark = "the mean colour of map_Ke is used for emission, which cannot be "
                               "textured, in \"a\"";
    const auto expectEmission = [&](const std::string& statements, const glm::dvec3& emission) {
        const Material material = remarkedMaterialOf(statements, remark);
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(material.emission[k], emission[k], 1e-6) << statements;
    };
    // IEC 61966-2-1: 128 / 255 is 0.2158605 in linear light.
    expectEmission("Ke 4 10 2\nmap_Ke screen.png\n", {2.0, 2.158605, 0.0});
    expectEmission("map_Ke screen.png\n", {0.5, 0.2158605, 0.0});
    expectEmission("map_Ke -colorspace linear screen.png\n", {0.5, 128.0 / 255.0, 0.0});
    EXPECT_EQ(materialOf("Ke 0 0 0\nmap_Ke screen.png\n").emission, glm::dvec3(0.0));
    EXPECT_EQ(remarkedMaterialOf("illum 4\nNi 1.5\nmap_Ke screen.png\n", remark).type,
              MaterialType::Diffuse); // glass cannot shine
    expectError(errorOfLoading("map_Ke scream.png\n"), "m.mtl:2", "did you mean \"screen.png\"?");
    LoadOptions options;
    options.missingTextures = MissingTextures::Warn;
    EXPECT_EQ(load("map_Ke none.png\n", options).materials.at(1).emission, glm::dvec3(0.0));
    EXPECT_EQ(load("Ke 3\nmap_Ke none.png\n", options).materials.at(1).emission, glm::dvec3(3.0));
}

TEST_F(MtlMapsTest, MapKeOfACutOutIsTheMeanOfWhatIsSeen) {
    files_.write("half.png", pngOf(2, 1, {{255, 255, 255, 255}, {0, 0, 0, 0}}));
    const auto emission = [&](const std::string& statements) {
        return load(statements).materials.at(1).emission;
    };
    EXPECT_EQ(emission("map_Ke half.png\nmap_d half.png\n"), glm::dvec3(1.0));
    EXPECT_EQ(emission("Ke 3\nmap_Kd half.png\nmap_Ke half.png\n"), glm::dvec3(3.0));
    EXPECT_EQ(emission("map_Ke half.png\n"), glm::dvec3(0.5)); // without holes
}

TEST_F(MtlMapsTest, MissingImages) {
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
    EXPECT_TRUE(std::ranges::any_of(scene.warnings, [](const std::string& warning) {
        return warning.find("there is no image file") != std::string::npos &&
               warning.find("(and 2 more of this kind, at ") != std::string::npos;
    }));
}

TEST_F(MtlMapsTest, TexturesLieBesideTheirMtl) {
    std::filesystem::create_directories(files_.path("lib"));
    files_.write("m.obj", "mtllib LIB\\m2.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    files_.write("lib/m2.mtl", "newmtl a\nmap_Kd green.png\n");
    files_.write("lib/green.png", pngOf({0, 255, 0, 255}));
    const Scene scene = load("");
    EXPECT_EQ(std::get<ImageTexture>(scene.textures.at(0).source).image->bytes[1], 255);
}

TEST_F(MtlMapsTest, IgnoredOptionsAreWarnedOfOnce) {
    remarkedMaterialOf("map_Kd -mm 0 0.5 red.png\nbump -mm 0 0.5 -t 1 grey.png\n",
                       "these MTL texture options are not supported and were ignored: "
                       "\"-mm\", \"-t\"");
}

} // namespace
} // namespace calotype::test
