// Textures of the scene file, and how their files are found.

#include <algorithm>
#include <filesystem>

#include "base/find_file.h"
#include "support/image_files.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

nlohmann::json sceneWithTexture(const std::string& texture) {
    nlohmann::json scene = plainScene();
    scene["textures"]["t"] = nlohmann::json::parse(texture);
    return scene;
}

class SceneTextureTest : public testing::Test {
protected:
    SceneTextureTest() { files_.write("red.png", pngOf({255, 0, 0, 255})); }

    Texture load(const std::string& texture) {
        return files_.load(sceneWithTexture(texture)).textures.at(0);
    }
    ImageTexture loadImage(const std::string& texture) {
        return std::get<ImageTexture>(load(texture).source);
    }
    SceneError errorOfLoading(const std::string& texture) {
        return errorOf([&] { load(texture); });
    }

    SceneFiles files_;
};

TEST_F(SceneTextureTest, ImagesHaveTheFormatsDefaults) {
    const Texture texture = load(R"({"type": "image", "file": "red.png"})");
    const auto image = std::get<ImageTexture>(texture.source);
    EXPECT_EQ(texture.name, "t");
    EXPECT_EQ(texture.scale, glm::dvec2(1.0));
    EXPECT_EQ(texture.offset, glm::dvec2(0.0));
    EXPECT_EQ(image.wrap, TextureWrap::Repeat);
    EXPECT_EQ(image.filter, TextureFilter::Bilinear);
    EXPECT_TRUE(image.decodesColor);
    ASSERT_EQ(image.image->bytes.size(), 16u);
    EXPECT_EQ(image.image->bytes[0], 255);
    EXPECT_EQ(image.image->bytes[1], 0);
}

TEST_F(SceneTextureTest, ImagesTakeEveryKey) {
    const std::string text = R"({"type": "image", "file": "red.png", "wrap": "mirror",
        "filter": "nearest", "color_space": "linear", "scale": [2, 0.5]})";
    const ImageTexture image = loadImage(text);
    EXPECT_EQ(image.wrap, TextureWrap::Mirror);
    EXPECT_EQ(image.filter, TextureFilter::Nearest);
    EXPECT_FALSE(image.decodesColor);
    EXPECT_EQ(load(text).scale, glm::dvec2(2.0, 0.5));
    EXPECT_EQ(loadImage(R"({"type": "image", "file": "red.png", "wrap": "clamp"})").wrap,
              TextureWrap::Clamp);
    EXPECT_TRUE(
        loadImage(R"({"type": "image", "file": "red.png", "color_space": "srgb"})").decodesColor);
}

TEST_F(SceneTextureTest, CheckersHaveTwoColoursAndAScale) {
    const Texture texture =
        load(R"({"type": "checker", "colors": [0.8, [0, 0.5, 1]], "scale": [8, 4]})");
    const auto checker = std::get<CheckerTexture>(texture.source);
    EXPECT_EQ(checker.colors[0], glm::dvec3(0.8));
    EXPECT_EQ(checker.colors[1], glm::dvec3(0.0, 0.5, 1.0));
    EXPECT_EQ(texture.scale, glm::dvec2(8.0, 4.0));
}

TEST_F(SceneTextureTest, MistakesNameTheirPlace) {
    expectError(errorOfLoading(R"({"type": "picture"})"), "scene.json: /textures/t/type",
                "\"image\", \"checker\"");
    expectError(errorOfLoading(R"({"type": "image"})"), "scene.json: /textures/t",
                "lacks \"file\"");
    expectError(errorOfLoading(R"({"type": "image", "file": "red.png", "warp": "clamp"})"),
                "scene.json: /textures/t/warp", "did you mean \"wrap\"?");
    expectError(errorOfLoading(R"({"type": "checker", "colors": [1, 0], "wrap": "clamp"})"),
                "scene.json: /textures/t/wrap", "unknown key");
    expectError(errorOfLoading(R"({"type": "checker", "colors": [1, 2]})"),
                "scene.json: /textures/t/colors/1", "in [0, 1]");
    expectError(errorOfLoading(R"({"type": "checker", "colors": [1, 0], "scale": [1, 0]})"),
                "scene.json: /textures/t/scale/1", "greater than 0");
    expectError(errorOfLoading(R"({"type": "checker", "colors": [1, 0], "scale": [1.1e9, 1]})"),
                "scene.json: /textures/t/scale/0", "at most 1e+09");
    expectError(errorOfLoading(R"({"type": "image", "file": "red.png", "scale": [1, 1e30]})"),
                "scene.json: /textures/t/scale/1", "at most 1e+09");
    expectError(errorOfLoading(R"({"type": "checker", "colors": [1, 0], "scale": 2})"),
                "scene.json: /textures/t/scale", "an array of 2");
}

TEST_F(SceneTextureTest, MissingFilesAreErrorsThatHelp) {
    const SceneError error = errorOfLoading(R"({"type": "image", "file": "rad.png"})");
    expectError(error, "scene.json: /textures/t/file", "\"rad.png\"; did you mean \"red.png\"?");
    expectError(error, "scene.json: /textures/t/file", "--missing-textures warn");
    std::filesystem::create_directories(files_.path("maps"));
    files_.write("maps/stone.png", pngOf({1, 2, 3, 255}));
    expectError(errorOfLoading(R"({"type": "image", "file": "maps/stine.png"})"),
                "scene.json: /textures/t/file", "did you mean \"maps/stone.png\"?");
}

TEST_F(SceneTextureTest, MissingFilesMayBeMagenta) {
    LoadOptions options;
    options.missingTextures = MissingTextures::Warn;
    const Scene scene =
        files_.load(sceneWithTexture(R"({"type": "image", "file": "none.png"})"), options);
    const auto& image = *std::get<ImageTexture>(scene.textures.at(0).source).image;
    EXPECT_EQ(image.bytes, (std::vector<uint8_t>{255, 0, 255, 255}));
    EXPECT_EQ(image.texelCount(), 1u);
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_NE(scene.warnings[0].find("/textures/t/file: there is no image file \"none.png\""),
              std::string::npos)
        << scene.warnings[0];
}

TEST_F(SceneTextureTest, UnreadableFilesAreLikeMissingOnes) {
    files_.write("corrupt.png", pngOf({1, 2, 3, 255}).substr(0, 50));
    files_.write("paint.dds", "DDS |...");
    files_.write("wide.png", pngFile(ImageTexture::kLargestSide + 1, 1, 8, 6, ""));
    std::filesystem::create_directories(files_.path("folder.png"));
    LoadOptions options;
    options.missingTextures = MissingTextures::Warn;
    const std::pair<const char*, const char*> files[] = {{"corrupt.png", "incomplete"},
                                                         {"paint.dds", "a DDS image"},
                                                         {"wide.png", "scale it down"},
                                                         {"folder.png", "is a folder"}};
    for (const auto& [name, reason] : files) {
        const std::string texture = R"({"type": "image", "file": ")" + std::string(name) + "\"}";
        const SceneError error = errorOfLoading(texture);
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("--missing-textures warn"), std::string::npos);
        const Scene scene = files_.load(sceneWithTexture(texture), options);
        EXPECT_TRUE(scene.textures.at(0).isMissing);
        EXPECT_EQ(std::get<ImageTexture>(scene.textures[0].source).image->bytes,
                  (std::vector<uint8_t>{255, 0, 255, 255}));
        ASSERT_FALSE(scene.warnings.empty());
        for (const std::string& part :
             {std::string(name), std::string(reason), std::string("/textures/t/file: "),
              std::string("; a colour shows magenta, another map is left out")})
            EXPECT_NE(scene.warnings[0].find(part), std::string::npos) << scene.warnings[0];
    }
}

TEST_F(SceneTextureTest, ManyUnreadableFilesAreCounted) {
    nlohmann::json scene = plainScene();
    for (int i = 0; i < 30; ++i) {
        const std::string name = std::to_string(i) + ".png";
        scene["textures"][name] = {{"type", "image"}, {"file", name}};
    }
    LoadOptions options;
    options.missingTextures = MissingTextures::Warn;
    const auto warnings = files_.load(scene, options).warnings;
    const auto ofFiles = std::ranges::find_if(
        warnings, [](const auto& w) { return w.find("no image file") != w.npos; });
    ASSERT_NE(ofFiles, warnings.end());
    EXPECT_NE(ofFiles->find("29 more"), ofFiles->npos) << *ofFiles;
    EXPECT_EQ(std::ranges::count_if(warnings,
                                    [](const auto& w) { return w.find("image file") != w.npos; }),
              1);
}

TEST_F(SceneTextureTest, UnreadableMapsAreLeftOut) {
    nlohmann::json scene = sceneWithTexture(R"({"type": "image", "file": "none.png"})");
    scene["materials"]["wall"] = {{"type", "nonmetal"},
                                  {"color", 0.5},
                                  {"roughness", "t"},
                                  {"specular", "t"},
                                  {"normal_map", "t"}};
    scene["materials"]["wall"]["displacement"] = {{"texture", "t"}, {"scale", 1}};
    LoadOptions options;
    options.missingTextures = MissingTextures::Warn;
    const Material material = files_.load(scene, options).materials.at(0);
    for (const uint32_t Material::*slot :
         {&Material::roughnessTexture, &Material::specularTexture, &Material::normalMap})
        EXPECT_EQ(material.*slot, Material::kNoTexture);
    EXPECT_EQ(material.specular, 0.04); // its default
    EXPECT_EQ(material.roughness, 1.0);
}

TEST_F(SceneTextureTest, EachFileIsReadOnce) {
    nlohmann::json scene = plainScene();
    scene["textures"]["a"] = {{"type", "image"}, {"file", "red.png"}};
    scene["textures"]["b"] = {{"type", "image"}, {"file", "RED.png"}, {"wrap", "clamp"}};
    const Scene loaded = files_.load(scene);
    EXPECT_EQ(std::get<ImageTexture>(loaded.textures.at(0).source).image,
              std::get<ImageTexture>(loaded.textures.at(1).source).image);
}

TEST_F(SceneTextureTest, TheirContentIsInTheHash) {
    const std::string texture = R"({"type": "image", "file": "red.png"})";
    const uint64_t before = files_.load(sceneWithTexture(texture)).hash;
    EXPECT_EQ(files_.load(sceneWithTexture(texture)).hash, before);
    files_.write("red.png", pngOf({254, 0, 0, 255}));
    EXPECT_NE(files_.load(sceneWithTexture(texture)).hash, before);
}

class FindFileTest : public testing::Test {
protected:
    FindFileTest() {
        std::filesystem::create_directories(files_.path("Textures/Old Wood"));
        for (const char* name : {"Textures/Old Wood/Oak 1.PNG", "a.png", "A.png", "b.Png"})
            files_.write(name, "");
    }

    /// What is found, relative to the folder; empty for nothing.
    std::string find(const std::string& name) {
        FileFinder finder;
        const auto found = finder.find(files_.path(""), name);
        return found ? std::filesystem::relative(*found, files_.path("")).string() : "";
    }

    SceneFiles files_;
};

TEST_F(FindFileTest, InAnyCaseAndWithAnySlash) {
    const std::string oak = "Textures/Old Wood/Oak 1.PNG";
    for (const char* name : {"Textures/Old Wood/Oak 1.PNG", "textures/old wood/oak 1.png",
                             "TEXTURES\\Old Wood\\OAK 1.png", "textures\\\\old wood\\\\oak 1.png",
                             ".\\Textures/../Textures/Old Wood//Oak 1.PNG"})
        EXPECT_EQ(find(name), oak) << name;
    EXPECT_EQ(find("a.png"), "a.png");
    EXPECT_EQ(find("A.png"), "A.png");
    EXPECT_EQ(find("A.PNG"), "A.png"); // the first in order
    EXPECT_EQ(find("B.PNG"), "b.Png");
    for (const char* name :
         {"", ".", "Textures", "Textures/", "c.png", "a.png/", "a.png/b.png", "../a.png/a.png"})
        EXPECT_EQ(find(name), "") << name;
}

TEST_F(FindFileTest, AbsolutePathsOfOtherMachinesEndHere) {
    EXPECT_EQ(find("C:\\Users\\me\\a.png"), "a.png");
    EXPECT_EQ(find("d:/models/textures/old wood/oak 1.png"), "Textures/Old Wood/Oak 1.PNG");
    EXPECT_EQ(find("\\\\server\\share\\B.png"), "b.Png");
    EXPECT_EQ(find("/no/such/folder/a.png"), "a.png");
    EXPECT_EQ(find("C:\\Users\\me\\c.png"), "");
    EXPECT_EQ(find(files_.path("a.png")), "a.png");
}

TEST_F(FindFileTest, FoldersThatDifferInCaseAreBothSearched) {
    std::filesystem::create_directories(files_.path("textures"));
    EXPECT_EQ(find("textures/old wood/oak 1.png"), "Textures/Old Wood/Oak 1.PNG");
}

// Each folder is listed once, so a name in another case, or of another machine, takes as long as a
// plain one.
TEST_F(FindFileTest, ManyNamesInALargeFolderTakeLittleTime) {
    std::filesystem::create_directories(files_.path("large"));
    for (int i = 0; i < 2000; ++i)
        files_.write("large/t" + std::to_string(i) + ".png", "");
    FileFinder finder;
    EXPECT_LT(processorSeconds([&] {
                  for (int i = 0; i < 1000; ++i) {
                      const std::string number = std::to_string(i);
                      EXPECT_TRUE(finder.find(files_.path("large"), "T" + number + ".PNG"));
                      EXPECT_TRUE(
                          finder.find(files_.path("large"), "C:\\a\\b\\T" + number + ".PNG"));
                      EXPECT_FALSE(finder.find(files_.path("large"), "gone" + number + ".png"));
                  }
              }),
              1.0);
}

TEST_F(FindFileTest, OddNamesTakeBoundedTime) {
    std::string deep;
    for (int i = 0; i < 500'000; ++i)
        deep += "/a";
    EXPECT_LT(processorSeconds([&] {
                  for (const std::string& name : {deep, "." + deep, std::string(1'000'000, '/'),
                                                  std::string(1'000'000, 'x'), "C:" + deep})
                      EXPECT_EQ(find(name), "");
              }),
              1.0);
}

} // namespace
} // namespace calotype::test
