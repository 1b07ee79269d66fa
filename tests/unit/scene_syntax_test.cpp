// JSON as text: syntax, comments, repeated keys, and files that are deep, long or out of range.

#include <string>

#include "scene_files.h"

namespace calotype::test {
namespace {

SceneError errorOfText(const std::string& text) {
    const SceneFiles files;
    return errorOf([&] { files.loadText(text); });
}

double secondsFor(const std::string& text) {
    const SceneFiles files;
    return processorSeconds([&] { errorOf([&] { files.loadText(text); }); });
}

TEST(SceneSyntaxTest, AcceptsCommentsOfBothKinds) {
    const SceneFiles files;
    const Scene scene = files.loadText("// first\n{ /* in\nside */ \"camera\": {} // last\n}");
    EXPECT_EQ(scene.film.width, 640u);
}

// What is wrong is said in the words of the JSON library, which change between its versions.
TEST(SceneSyntaxTest, NamesLineAndColumn) {
    const std::string words = "syntax error";
    expectError(errorOfText("{\n  \"camera\": {},\n  \"film\" {}\n}"), "scene.json:3:10", words);
    expectError(errorOfText(" "), "scene.json:1:2", words);
    expectError(errorOfText("{\"camera\": {}"), "scene.json:1:14", words);
    expectError(errorOfText("{} {}"), "scene.json:1:4", words);
    expectError(errorOfText("{\"camera\": {} /* open"), "scene.json:1:22", words);
}

TEST(SceneSyntaxTest, SaysThatACommaIsTooMany) {
    const std::string words = "there is a comma after the last value; remove it";
    expectError(errorOfText("{\"camera\": {},}"), "scene.json:1:14", words);
    expectError(errorOfText("{\"camera\": {\"up\": [0, 1, 0,\n ]}}"), "scene.json:1:27", words);
    expectError(errorOfText("{\"camera\": {}, // \"}\n/* , */ }"), "scene.json:1:14", words);
    expectError(errorOfText("{\"a\": \",\"]"), "scene.json:1:10", "syntax error");
    expectError(errorOfText("{\"a\": 1 /*,*/ ]"), "scene.json:1:15", "syntax error");
}

TEST(SceneSyntaxTest, SaysWhatAFileIsInstead) {
    const std::vector<std::pair<std::string, std::string>> files = {
        {"ply\nformat ascii 1.0\n", "is a PLY mesh"},
        {"solid teapot\n", "is an STL mesh"},
        {std::string("glTF\2\0\0\0", 8), "is a binary glTF file (GLB)"},
        {"{\"asset\": {\"version\": \"2.0\"}, \"nodes\": []}", "is a glTF file"},
        {"\x89PNG\r\n", "is a PNG image"},
        {"RIFF\x10\x10\x10\x10WEBP", "is a WebP image"},
        {"# A text", "is neither a scene (JSON), which starts with {, nor"},
        {"WorldBegin", "is neither a scene"},
    };
    for (const auto& [text, words] : files)
        expectError(errorOfText(text), "scene.json", words);
}

// In every object, whatever its kind.
TEST(SceneSyntaxTest, AllowsADescriptionEverywhere) {
    const SceneFiles files;
    const Scene scene = files.loadText(R"({
        "description": "a test",
        "camera": { "description": "the view" },
        "film": { "description": "small", "width": 8 },
        "textures": { "description": "patterns",
                      "squares": { "type": "checker", "colors": [0, 1] } },
        "materials": { "description": "paints",
                       "red": { "description": "paint", "type": "diffuse", "color": "squares" } },
        "shapes": [{ "description": "ball", "type": "sphere", "radius": 1, "material": "red",
                     "transform": { "description": "moved", "translate": [1, 0, 0] } }]
    })");
    EXPECT_EQ(scene.film.width, 8u);
    ASSERT_EQ(scene.materials.size(), 1u);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.materials[0].name, "red");
    EXPECT_EQ(scene.textures[0].name, "squares");
    EXPECT_TRUE(scene.warnings.size() <= 1u); // that nothing emits light
    expectError(errorOfText(R"({"camera": {"description": 3}})"), "scene.json: /camera/description",
                "must be");
}

// Only a text is no material.
TEST(SceneSyntaxTest, AMaterialCanBeCalledDescription) {
    const SceneFiles files;
    const Scene scene = files.loadText(R"({
        "camera": {},
        "materials": { "description": { "type": "diffuse", "color": 0.5 } },
        "shapes": [{ "type": "sphere", "radius": 1, "material": "description" }]
    })");
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].name, "description");
    expectError(errorOfText(R"({"camera": {}, "materials": {"description": 3}})"),
                "scene.json: /materials/description", "must be an object");
}

TEST(SceneSyntaxTest, SaysThatAFileIsEmpty) {
    expectError(errorOfText(""), "scene.json:1:1", "the file is empty");
}

TEST(SceneSyntaxTest, CountsCharactersNotBytes) {
    // Two-byte letters: the comma stands in column 8.
    expectError(errorOfText("{\"\u00e4\u00f6\u00fc\":,}"), "scene.json:1:8", "syntax error");
}

TEST(SceneSyntaxTest, RefusesRepeatedKeysWithTheirPointer) {
    expectError(errorOfText("{\"camera\": {}, \"camera\": {}}"), "scene.json: /camera", "repeated");
    expectError(errorOfText("{\"camera\": {\"fov\": 40, \"fov\": 41}}"), "scene.json: /camera/fov",
                "the key \"fov\" is repeated");
    expectError(errorOfText("{\"shapes\": [1, {\"a\": [[]], \"b/c\": 1, \"b/c\": 1}]}"),
                "scene.json: /shapes/1/b~1c", "repeated");
}

TEST(SceneSyntaxTest, RefusesNumbersBeyondDoubles) {
    expectError(errorOfText("{\"camera\": {\"fov\": 1e999}}"), "scene.json: /camera/fov",
                "\"1e999\" is larger");
    expectError(errorOfText("{\"camera\": {\"up\": [0, -1e999, 0]}}"), "scene.json: /camera/up/1",
                "larger");
}

TEST(SceneSyntaxTest, RefusesTextThatIsNotUtf8) {
    expectError(errorOfText("{\"\xff\": 1}"), "scene.json:1:3", "UTF-8");
}

TEST(SceneSyntaxTest, RefusesOtherRootsThanAnObject) {
    expectError(errorOfText("[]"), "scene.json", "must be an object, not an array");
}

TEST(SceneSyntaxTest, MessagesStayOnOneLine) {
    const SceneError error = errorOfText("{\"camera\": {\"a\\nb\": 1}}");
    expectError(error, "scene.json: /camera/a\\nb", "unknown key \"a\\nb\"");
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
}

TEST(SceneSyntaxTest, DeepNestingNeitherCrashesNorLasts) {
    const size_t depth = 1'000'000;
    expectError(errorOfText(std::string(depth, '[')), "scene.json: /0", "more than 100 deep");
    std::string closed = "{\"camera\": " + std::string(depth, '[') + std::string(depth, ']') + "}";
    expectError(errorOfText(closed), "scene.json: /camera", "more than 100 deep");
    EXPECT_LT(secondsFor(closed), 1.0);
}

TEST(SceneSyntaxTest, NestingOfAHundredIsStillRead) {
    const std::string text = "{\"camera\": " + std::string(99, '[') + std::string(99, ']') + "}";
    expectError(errorOfText(text), "scene.json: /camera", "must be an object");
}

TEST(SceneSyntaxTest, LongNamesAreShortenedAndCostNothing) {
    const std::string name(1'000'000, 'k');
    for (const std::string& text :
         {"{\"" + name + "\": 1}", "{\"camera\": {\"type\": \"" + name + "\"}}", "\"" + name,
          "{\"camera\": {\"fov\": " + std::string(1'000'000, '9') + "}}"}) {
        EXPECT_LT(secondsFor(text), 1.0);
        EXPECT_LT(std::string(errorOfText(text).what()).size(), 500u);
    }
}

TEST(SceneSyntaxTest, ManyRepetitionsOfAKeyStopAtTheFirst) {
    std::string text = "{";
    for (int i = 0; i < 100'000; ++i)
        text += "\"a\": 1, ";
    EXPECT_LT(secondsFor(text + "\"a\": 1}"), 1.0);
}

} // namespace
} // namespace calotype::test
