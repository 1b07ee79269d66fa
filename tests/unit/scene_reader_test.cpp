// The reader's rules, one mutation of a valid scene each: where it complains and what it says.

#include <string>
#include <vector>

#include "scene_files.h"

namespace calotype::test {
namespace {

const char* const kValidScene = R"({
    "$schema": "scene.schema.json",
    "camera": {"type": "perspective", "position": [0, 1, 4], "target": [0, 1, 0], "up": [0, 1, 0],
               "fov": 40, "lens_radius": 0, "focus_distance": 4},
    "film": {"width": 640, "height": 480, "filter": "box"},
    "render": {"spp": 64, "max_bounces": 4, "seed": 0},
    "background": 0,
    "textures": {},
    "materials": {
        "wall": {"type": "diffuse", "color": 0.7},
        "lamp": {"type": "diffuse", "color": "#000000", "emission": [12, 11, 9],
                 "emission_side": "front"}
    },
    "shapes": [
        {"type": "sphere", "center": [0, 0.5, 0], "radius": 0.5, "material": "wall"},
        {"type": "cylinder", "center": [1, 0.5, 0], "radius": 0.3, "height": 1, "axis": [0, 1, 0],
         "material": "lamp"},
        {"type": "cone", "apex": [-1, 1, 0], "height": -1, "slope": 0.45, "material": "wall",
         "transform": {"translate": [0, 1, 0], "rotate": [0, 45, 0], "scale": 2}},
        {"type": "disk", "center": [0, 0, 0], "normal": [0, 1, 0], "radius": 2, "material": "wall"},
        {"type": "triangle", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "material": "wall"},
        {"type": "quad", "vertices": [[-2, 0, 2], [2, 0, 2], [2, 0, -2], [-2, 0, -2]],
         "material": "wall", "transform": {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}},
        {"type": "mesh", "file": "triangle.obj", "material": "wall", "normals": "auto"}
    ],
    "lights": [
        {"type": "disk", "center": [0, 3, 0], "normal": [0, -1, 0], "radius": 0.5, "radiance": 20},
        {"type": "triangle", "vertices": [[0, 4, 0], [1, 4, 0], [0, 4, 1]], "power": [20, 18, 15],
         "two_sided": true, "visible": false}
    ]
})";

void writeTriangle(const SceneFiles& files) {
    files.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}

struct Mistake {
    std::string pointer;  ///< what is set
    std::string value;    ///< to this JSON; nothing removes it
    std::string where;    ///< pointer of the complaint
    std::string fragment; ///< of the message
};

std::string nameOf(const testing::TestParamInfo<Mistake>& info) {
    std::string name = std::to_string(info.index);
    for (const char c : info.param.pointer)
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

TEST(SceneReaderTest, AcceptsTheValidScene) {
    const SceneFiles files;
    writeTriangle(files);
    const Scene scene = files.loadText(kValidScene);
    EXPECT_EQ(scene.shapes.size(), 9u);
    EXPECT_EQ(scene.materials.size(), 4u);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
    EXPECT_TRUE(scene.shapes[2].place.ends_with("scene.json: /shapes/2")) << scene.shapes[2].place;
    EXPECT_TRUE(scene.shapes[7].place.ends_with("scene.json: /lights/0")) << scene.shapes[7].place;
}

class MistakeTest : public testing::TestWithParam<Mistake> {};

TEST_P(MistakeTest, IsAnErrorWithItsPlace) {
    const SceneFiles files;
    writeTriangle(files);
    const Mistake& mistake = GetParam();
    nlohmann::json scene = nlohmann::json::parse(kValidScene);
    const nlohmann::json::json_pointer pointer(mistake.pointer);
    if (mistake.value.empty())
        scene.at(pointer.parent_pointer()).erase(pointer.back());
    else
        scene[pointer] = nlohmann::json::parse(mistake.value);
    const SceneError error = errorOf([&] { files.load(scene); });
    expectError(error, mistake.where.empty() ? "scene.json" : "scene.json: " + mistake.where,
                mistake.fragment);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, MistakeTest,
    testing::ValuesIn(std::vector<Mistake>{
        {"/shaeps", "[]", "/shaeps", "unknown key \"shaeps\"; did you mean \"shapes\"?"},
        {"/camera", "", "", "lacks \"camera\""},
        {"/camera", "[]", "/camera", "must be an object"},
        {"/camera/fvo", "40", "/camera/fvo", "did you mean \"fov\"?"},
        {"/film/widht", "1", "/film/widht", "did you mean \"width\"?"},
        {"/render/bounces", "1", "/render/bounces", "did you mean \"max_bounces\"?"},
        {"/materials/wall/colour", "1", "/materials/wall/colour", "did you mean \"color\"?"},
        {"/materials/wall/zzz", "1", "/materials/wall/zzz", "known here: \"type\", \"color\""},
        {"/materials/wall/type", "", "/materials/wall", "lacks \"type\""},
        {"/materials/wall/color", "", "/materials/wall", "lacks \"color\""},
        {"/shapes/0", "{\"tpye\": \"sphere\"}", "/shapes/0", "is \"tpye\" a misspelling of it?"},
        {"/shapes/0/type", "\"spere\"", "/shapes/0/type", "did you mean \"sphere\"?"},
        {"/shapes/0/type", "7", "/shapes/0/type", "must be a text"},
        {"/shapes/0/raduis", "1", "/shapes/0/raduis", "did you mean \"radius\"?"},
        {"/shapes/0/radius", "", "/shapes/0", "lacks \"radius\""},
        {"/shapes/0/material", "", "/shapes/0", "lacks \"material\""},
        {"/shapes/0/axis", "[0, 1, 0]", "/shapes/0/axis", "unknown key"},
        {"/shapes/5/normal", "[0, 1, 0]", "/shapes/5/normal", "unknown key"},
        {"/shapes/2/transform/rotation", "1", "/shapes/2/transform/rotation", "mean \"rotate\"?"},
        {"/lights/0/material", "\"wall\"", "/lights/0/material", "unknown key"},
        {"/lights/1/visibel", "true", "/lights/1/visibel", "did you mean \"visible\"?"},
        {"/a~1b~0c", "1", "/a~1b~0c", "unknown key \"a/b~c\""},
    }),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Values, MistakeTest,
    testing::ValuesIn(std::vector<Mistake>{
        {"/$schema", "1", "/$schema", "must be a text"},
        {"/camera/position", "[0, 1]", "/camera/position", "must be an array of 3 numbers"},
        {"/camera/position", "[0, 1, \"2\"]", "/camera/position/2", "must be a number"},
        {"/camera/target", "[0, 1, 4]", "/camera/target", "is the camera's position too"},
        {"/camera/up", "[0, 0, 0]", "/camera/up", "must not be zero"},
        {"/camera/up", "[0, 0, -3]", "/camera/up", "is parallel to the direction of view"},
        {"/camera/fov", "0", "/camera/fov", "between 0 and 180"},
        {"/camera/fov", "180", "/camera/fov", "between 0 and 180"},
        {"/camera/fov", "true", "/camera/fov", "must be a number, not true"},
        {"/camera/focus_distance", "0", "/camera/focus_distance", "greater than 0"},
        {"/film/width", "0", "/film/width", "from 1 to 65535, not 0"},
        {"/film/height", "65536", "/film/height", "from 1 to 65535, not 65536"},
        {"/film/height", "1.5", "/film/height", "whole number"},
        {"/film/filter", "\"bx\"", "/film/filter", "did you mean \"box\"?"},
        {"/render/spp", "0", "/render/spp", "from 1 to"},
        {"/render/spp", "1073741825", "/render/spp", "whole number"},
        {"/render/max_bounces", "1048577", "/render/max_bounces", "from 0 to 1048576"},
        {"/render/max_bounces", "-1", "/render/max_bounces", "from 0 to"},
        {"/materials", "[]", "/materials", "must be an object"},
        {"/materials/wall/color", "1.01", "/materials/wall/color", "must be in [0, 1], not 1.01"},
        {"/materials/wall/color", "[0, -0.1, 0]", "/materials/wall/color/1", "in [0, 1]"},
        {"/materials/wall/color", "[0, 0]", "/materials/wall/color", "must be a colour"},
        {"/materials/wall/color", "\"#12345g\"", "/materials/wall/color", "#rrggbb"},
        {"/materials/wall/color", "\"#1234567\"", "/materials/wall/color", "#rrggbb"},
        {"/materials/lamp/emission", "-1", "/materials/lamp/emission", "0 or greater, not -1"},
        {"/materials/lamp/emission_side", "\"bak\"", "/materials/lamp/emission_side", "one of"},
        {"/shapes", "{}", "/shapes", "must be an array"},
        {"/shapes/0", "3", "/shapes/0", "must be an object"},
        {"/shapes/0/material", "\"wal\"", "/shapes/0/material", "did you mean \"wall\"?"},
        {"/shapes/0/radius", "0", "/shapes/0/radius", "greater than 0"},
        {"/shapes/0/radius", "-1", "/shapes/0/radius", "greater than 0, not -1"},
        {"/shapes/1/height", "-1", "/shapes/1/height", "greater than 0"},
        {"/shapes/1/axis", "[0, 0, 0]", "/shapes/1/axis", "must not be zero"},
        {"/shapes/1/transform", "{}", "/shapes/1/axis", "exclude each other"},
        {"/shapes/2/height", "0", "/shapes/2/height", "must not be 0"},
        {"/shapes/2/slope", "0", "/shapes/2/slope", "greater than 0"},
        {"/shapes/2/transform/scale", "0", "/shapes/2/transform/scale", "must not be 0"},
        {"/shapes/2/transform/scale", "[1, 2, 1]", "/shapes/2/transform", "uniform scale only"},
        {"/shapes/2/transform/matrix", "[]", "/shapes/2/transform/translate", "exclude each other"},
        {"/shapes/3/normal", "[0, 0, 0]", "/shapes/3/normal", "must not be zero"},
        {"/shapes/4/vertices/2", "[2, 0, 0]", "/shapes/4", "no triangle of this shape has an area"},
        {"/shapes/4/vertices/2", "[1, 0, 0]", "/shapes/4", "no triangle of this shape has an area"},
        {"/shapes/4/vertices", "[[0, 0, 0]]", "/shapes/4/vertices", "must be an array of 3"},
        {"/shapes/5/vertices/2", "[2, 0.01, -2]", "/shapes/5/vertices", "do not lie in one plane"},
        {"/shapes/5/transform/matrix/12", "1", "/shapes/5/transform/matrix", "last row"},
        {"/shapes/5/transform/matrix/5", "0", "/shapes/5/transform/matrix", "flattens space"},
        {"/shapes/5/transform/matrix", "[1]", "/shapes/5/transform/matrix", "an array of 16"},
        {"/shapes/6/file", "\"none.obj\"", "/shapes/6/file", "cannot read the file"},
        {"/shapes/6/file", "\".\"", "/shapes/6/file", "cannot read the file"},
        {"/shapes/6/normals", "\"round\"", "/shapes/6/normals", "must be one of"},
        {"/shapes/6/materials", "{}", "/shapes/6/materials", "exclude each other"},
        {"/lights/0/radiance", "", "/lights/0", "lacks \"radiance\""},
        {"/lights/0/radiance", "[1, -1, 1]", "/lights/0/radiance/1", "0 or greater"},
        {"/lights/0/power", "1", "/lights/0/power", "exclude each other"},
        {"/lights/0/visible", "1", "/lights/0/visible", "must be true or false"},
        {"/lights/0/transform", "{\"scale\": [1, 1, 3]}", "/lights/0/transform",
         "uniform scale only"},
        {"/lights/1/type", "\"sphere\"", "/lights/1/type", "must be one of \"disk\""},
    }),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Cameras, MistakeTest,
    testing::ValuesIn(std::vector<Mistake>{
        {"/camera/type", "\"orthografic\"", "/camera/type", "did you mean \"orthographic\"?"},
        {"/camera", R"({"type": "orthographic"})", "/camera", "lacks \"height\""},
        {"/camera", R"({"type": "orthographic", "height": 0})", "/camera/height", "greater than 0"},
        {"/camera", R"({"type": "orthographic", "height": 1, "fov": 40})", "/camera/fov",
         "belongs to a perspective camera"},
        {"/camera/height", "2", "/camera/height", "belongs to an orthographic camera"},
        {"/camera/lens_radius", "-0.1", "/camera/lens_radius", "must be 0 or greater, not -0.1"},
        {"/camera", R"({"lens_radius": 0.1})", "/camera", "lacks \"focus_distance\""},
        {"/film/filter", "\"gausian\"", "/film/filter", "did you mean \"gaussian\"?"},
    }),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Uvs, MistakeTest,
    testing::ValuesIn(std::vector<Mistake>{
        {"/shapes/4/uvs", "[]", "/shapes/4/uvs", "must be an array of 3"},
        {"/shapes/5/uvs", "[[0, 0], [1, 0], [1, 1]]", "/shapes/5/uvs", "must be an array of 4"},
        {"/shapes/4/uvs", "[[0, 0], [1, 0, 0], [1, 1]]", "/shapes/4/uvs/1", "an array of 2"},
        {"/shapes/4/uvs", "[[0, 0], [1, 0], [1, null]]", "/shapes/4/uvs/2/1", "a number"},
        {"/shapes/0/uvs", "[]", "/shapes/0/uvs", "unknown key"},
        {"/lights/1/uvs", "[[0, 0], [1, 0], [1, 1]]", "/lights/1/uvs", "unknown key"},
    }),
    nameOf);

} // namespace
} // namespace calotype::test
