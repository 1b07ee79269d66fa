// What the check of OBJ texts lets pass and what it refuses, with the line.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "read/obj/outline.h"
#include "scene_files.h"

namespace calotype {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ObjCheckTest, CountsWhatItSees) {
    const ObjOutline outline = checkObj(
        kTriangle +
            "vn 0 0 1\nvt 0 0\nmtllib a b.mtl\nf 1 2 3\nusemtl  red one \nf 1 2 3\nf 1 2 3\n"
            "usemtl blue\nusemtl red one\nf 3//1 2//1 1//1\nusemtl\nf 1/1 2/1 3/1 1/1\n",
        "a.obj");
    EXPECT_EQ(outline.positions, 3u);
    EXPECT_EQ(outline.normals, 1u);
    EXPECT_EQ(outline.polygons, 5u);
    EXPECT_EQ(outline.corners, 16u);
    EXPECT_EQ(outline.libraries, std::vector<std::string>{"a b.mtl"});
    // "blue" is on no face.
    EXPECT_EQ(outline.materialNames, std::vector<std::string>{"red one"});
    EXPECT_EQ(outline.materialLines, std::vector<size_t>{9});
    ASSERT_EQ(outline.materialRuns.size(), 3u);
    EXPECT_EQ(outline.materialRuns[0].firstPolygon, 1u);
    EXPECT_EQ(outline.materialRuns[0].material, 0u);
    EXPECT_EQ(outline.materialRuns[2].firstPolygon, 4u);
    EXPECT_EQ(outline.materialRuns[2].material, ObjOutline::kNoMaterial);
}

TEST(ObjCheckTest, AcceptsWhatIsLegalOrDoesNotMatter) {
    const std::vector<std::string> texts = {
        kTriangle + "f 1 2 3",
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        "\tv\t0 0 0 \n  v 1 0 0\n v 0 1 0 # top\n # comment\n\n  f  1\t2 3 # face\n",
        "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n",
        "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n",
        "v +0 .0 0.\nv 1e0 -0 0e999\nv 0 1E+0 1e-999\nf 1 2 3\n",
        kTriangle + "vt 0\nvt 0 1\nvt 0 1 2\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 1//1 2//1 3//1\n"
                    "f 1/1 2/2 3/3\nf 1/ 2// 3/1/\n",
        kTriangle + "f -3 -2 -1\n",
        "f 1 2 3\n" + kTriangle,
        kTriangle + "f 1 \\\n2 \\\r\n3\n",
        "# C:\\path\\\n" + kTriangle + "f 1 2 3\n",
        kTriangle + "g a\no\ns off\nl 9 8\np 7\ncurv 0 1\nvp x\nnonsense ...\nf 1 2 3\n",
        // Not used by any face, so of no matter.
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 x\nv nan 0 0\nvn 0 0\nvt zero\nf 1 2 3\n",
        kTriangle + "vn nan 0 inf\nf 1//1 2//1 3//1\n",
        kTriangle + "vt 1e30 0\nvt 1e9 -1e9 1e30\nf 1/2 2/2 3/2\n",
    };
    for (const std::string& text : texts)
        EXPECT_NO_THROW(checkObj(text, "a.obj")) << text;
}

TEST(ObjCheckTest, ListsNormalsThatAreNotFinite) {
    const ObjOutline outline =
        checkObj(kTriangle + "vn 0 0 1\nvn nan 0 1\nvn 0 inf 1\nf 1//1 2//2 3//3\n", "a.obj");
    EXPECT_EQ(outline.nonFiniteNormals, (std::vector<size_t>{1, 2}));
}

struct Refusal {
    std::string text;
    size_t line;
    std::string fragment;
};

TEST(ObjCheckTest, RefusesWithTheLine) {
    const std::vector<Refusal> refusals = {
        {"v 0 0 0\nv 1 0 abc\nv 0 1 0\nf 1 2 3\n", 2, "\"abc\" is not a number"},
        {"v 0 0 0\nv 1 0 1.#IND\nv 0 1 0\nf 1 2 3\n", 2, "\"1.#IND\" is not a number"},
        {"v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", 2, "needs 3 numbers, not 2"},
        {"v 0 0 0\nv 1 0 0 red\nv 0 1 0\nf 1 2 3\n", 2, "\"red\" is not a number"},
        {"v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n", 2, "not finite"},
        {"v 0 0 0\nv 1 0 -inf\nv 0 1 0\nf 1 2 3\n", 2, "not finite"},
        {"v 0 0 0\nv 1 0 1e999\nv 0 1 0\nf 1 2 3\n", 2, "not finite"},
        {"v 0 0 0\nv\nv 0 1 0\nf 1 2 3\n", 2, "lacks its coordinates"},
        {"f 1 2 3\nv 0 0 0\nv 1 0 x\nv 0 1 0\n", 3, "\"x\" is not a number"},
        {kTriangle + "vn 0 0\nf 1//1 2//1 3//1\n", 4, "a normal needs 3 numbers, not 2"},
        {kTriangle + "vt x\nf 1/1 2/1 3/1\n", 4, "\"x\" is not a number"},
        {kTriangle + "vt 0 inf\nf 1/1 2/1 3/1\n", 4, "texture coordinate is not finite"},
        {kTriangle + "vt 1.1e9\nf 1/1 2/1 3/1\n", 4, "must be in [-1e+09, 1e+09]"},
        {kTriangle + "vt 0 -1e30\nf 1/1 2/1 3/1\n", 4, "must be in [-1e+09, 1e+09]"},
        {kTriangle + "f 1 2\n", 4, "at least 3 corners, not 2"},
        {kTriangle + "f\n", 4, "at least 3 corners, not 0"},
        {kTriangle + "f 1 2 0\n", 4, "index 0"},
        {kTriangle + "f 1/0 2/0 3/0\n", 4, "index 0"},
        {kTriangle + "f 1 2 4\nf 1 2 9\n", 5, "position 9 does not exist; the file has 3"},
        {kTriangle + "f 1 2 99999999999999999999\n", 4, "does not exist"},
        {kTriangle + "f 1/1 2/1 3/1\n", 4, "texture coordinate 1 does not exist; the file has 0"},
        {kTriangle + "f 1//2 2//2 3//2\n", 4, "normal 2 does not exist; the file has 0"},
        {kTriangle + "f -1 -2 -4\n", 4, "counts back beyond the first position (there are 3"},
        {"f -1 -1 -1\n" + kTriangle, 1, "counts back beyond the first position (there are 0"},
        {kTriangle + "f 1 2 3x\n", 4, "\"3x\" is malformed"},
        {kTriangle + "f 1 2 /3\n", 4, "\"/3\" is malformed"},
        {kTriangle + "f 1 2 3/1/1/1\n", 4, "malformed"},
        {kTriangle + "f 1 2 3.0\n", 4, "malformed"},
        {kTriangle + "f 1 2 3#c\n", 4, "malformed"},
        {kTriangle + "\n\nf 1 \\\n2 \\\nx\n", 6, "\"x\" is malformed"},
        {"v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2\r", 4, "at least 3 corners"},
        {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2\r\n", 4, "at least 3 corners"},
    };
    for (const Refusal& refusal : refusals) {
        try {
            checkObj(refusal.text, "a.obj");
            ADD_FAILURE() << "accepted: " << refusal.text;
        } catch (const SceneError& error) {
            EXPECT_EQ(error.where(), "a.obj:" + std::to_string(refusal.line)) << refusal.text;
            EXPECT_NE(std::string(error.what()).find(refusal.fragment), std::string::npos)
                << error.what();
        }
    }
}

TEST(ObjCheckTest, TakesTimeInProportion) {
    const auto secondsFor = [](const std::string& text) {
        return test::processorSeconds([&] {
            try {
                checkObj(text, "a.obj");
            } catch (const SceneError&) {
            }
        });
    };
    std::string carriageReturns;
    std::string continuations = "f";
    std::string garbage = kTriangle + "f 1 2 3\n";
    for (int i = 0; i < 200'000; ++i) {
        carriageReturns += "v 0 0 0\r";
        continuations += " 1 \\\n";
        garbage += "v x\n";
    }
    EXPECT_LT(secondsFor(carriageReturns), 1.0);
    EXPECT_LT(secondsFor(continuations), 1.0);
    EXPECT_LT(secondsFor(garbage), 1.0);
    EXPECT_LT(secondsFor(std::string(10'000'000, 'f')), 1.0);
}

} // namespace
} // namespace calotype
