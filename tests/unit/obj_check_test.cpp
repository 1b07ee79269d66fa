// What the outline of an OBJ counts, which blemishes a model may have and how they are told, and
// what is refused.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/text_cursor.h"
#include "read/obj/obj_file.h"
#include "read/obj/outline.h"
#include "scene_files.h"

namespace calotype {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::vector<std::string> notesOf(const std::string& text) {
    std::vector<std::string> messages;
    for (const ObjNote& note : parseObj(text, "a.obj").notes) {
        EXPECT_TRUE(note.message.starts_with(note.kind));
        messages.push_back(note.message);
    }
    return messages;
}

TEST(ObjCheckTest, CountsWhatItSees) {
    const ObjOutline outline = outlineOfObj(
        kTriangle +
        "vn 0 0 1\nvt 0 0\nmtllib a b.mtl\nf 1 2 3\nusemtl  red one \nf 1 2 3\nf 1 2 3\n"
        "usemtl blue\nf 1 2\nusemtl red one\nf 3//1 2//1 1//1\nusemtl\nf 1/1 2/1 3/1 1/1\n");
    EXPECT_EQ(outline.counts[kObjPosition], 3u);
    EXPECT_EQ(outline.counts[kObjNormal], 1u);
    EXPECT_EQ(outline.counts[kObjTexcoord], 1u);
    EXPECT_EQ(outline.polygons, 5u);
    EXPECT_EQ(outline.corners, 16u);
    EXPECT_EQ(outline.libraries, std::vector<std::string>{"a b.mtl"});
    // "blue" is on no face of three corners.
    EXPECT_EQ(outline.materialNames, std::vector<std::string>{"red one"});
    EXPECT_EQ(outline.materialLines, std::vector<size_t>{9});
    ASSERT_EQ(outline.materialRuns.size(), 3u);
    EXPECT_EQ(outline.materialRuns[0].firstPolygon, 1u);
    EXPECT_EQ(outline.materialRuns[0].material, 0u);
    EXPECT_EQ(outline.materialRuns[2].firstPolygon, 4u);
    EXPECT_EQ(outline.materialRuns[2].material, ObjOutline::kNoMaterial);
}

TEST(ObjCheckTest, FollowsSmoothingGroups) {
    const std::string face = "f 1 2 3\n";
    const ObjOutline outline =
        outlineOfObj(kTriangle + face + "s 7\n" + face + "s off\n" + face + "s 7\ns 2\n" + face +
                     "s 7\n" + face + face + "s 0\n" + face + "s OFF\ns\n" + face);
    const std::vector<std::pair<size_t, uint32_t>> expected = {
        {1, 1}, {2, 0}, {3, 2}, {4, 1}, {6, 0}};
    ASSERT_EQ(outline.smoothingRuns.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(outline.smoothingRuns[i].firstPolygon, expected[i].first) << i;
        EXPECT_EQ(outline.smoothingRuns[i].group, expected[i].second) << i;
    }
}

TEST(ObjCheckTest, AcceptsWhatIsLegalOrDoesNotMatter) {
    const std::vector<std::string> texts = {
        kTriangle + "f 1 2 3",
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        "\tv\t0 0 0 \n  v 1 0 0\n v 0 1 0 # top\n # comment\n\n  f  1\t2 3 # face\n",
        "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n",
        "v +0 .0 0.\nv 1e0 -0 0e999\nv 0 1E+0 1e-999\nf 1 2 3\n",
        kTriangle + "vt 0\nvt 0 1\nvt 0 1 2\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 1//1 2//1 3//1\n"
                    "f 1/1 2/2 3/3\nf 1/ 2// 3/\n",
        kTriangle + "f -3 -2 -1\n",
        "f 1 2 3\n" + kTriangle,
        kTriangle + "f 1 \\\n2 \\\r\n3\n",
        "# C:\\path\\\n" + kTriangle + "f 1 2 3\n",
        kTriangle + "g a\no\ns off\nvp x\nnonsense ...\nf 1 2 3\n",
        // Not used by any face, so of no matter.
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 x\nv nan 0 0\nvn 0 0\nvt zero\nvt nan nan\nf 1 2 3\n",
        kTriangle + "v\nvt\nvn # none\nf 1 2 3\n",
        kTriangle + "vt 1e30 0\nvt 1e9 -1e9 1e30\nf 1/2 2/2 3/2\n",
    };
    for (const std::string& text : texts)
        EXPECT_EQ(notesOf(text), std::vector<std::string>()) << text;
}

// Every spelling of C's printf, and of Microsoft's older one with all its roundings.
TEST(ObjCheckTest, ReadsEverySpellingOfNumbersThatAreNotFinite) {
    for (const char* word : {"nan",
                             "-nan",
                             "NAN",
                             "NaN",
                             "+nan",
                             "nan(0x8000)",
                             "-nan(ind)",
                             "nan(snan)",
                             "NAN(IND)",
                             "1.#QNB",
                             "-1.#SNB",
                             "1.#qnb",
                             "-1.#IND00e+000",
                             "1.#QNAN0e+000",
                             "1.#QNBE+000",
                             "1.#Je+000",
                             "1.$e+000",
                             "-1.#INDe-05",
                             "1.#IND",
                             "-1.#IND",
                             "1.#IND00",
                             "1.#QNAN",
                             "-1.#QNAN0",
                             "1.#SNAN",
                             "1.#qnan",
                             "-1.#ind",
                             "1.#J",
                             "-1.#J",
                             "1.#R",
                             "1.#IO",
                             "1.#QO",
                             "1.$",
                             "-1.$"}) {
        ASSERT_TRUE(parseNumber(word)) << word;
        EXPECT_TRUE(std::isnan(*parseNumber(word))) << word;
    }
    for (const char* word :
         {"inf", "INF", "+inf", "infinity", "Infinity", "1.#INF", "1.#INF00", "1.#inf", "+1.#INF",
          "1e999", "1.#INF00e+000", "1.#INFE+000", "1.#INF0e+00"})
        EXPECT_EQ(parseNumber(word), HUGE_VAL) << word;
    for (const char* word :
         {"-inf", "-Infinity", "-1.#INF", "-1.#INF000", "-1e999", "-1.#INF00e+000"}) {
        ASSERT_TRUE(parseNumber(word)) << word;
        EXPECT_TRUE(std::isinf(*parseNumber(word))) << word;
    }
    for (const char* word : {"1.#", "1.#x", "1.#INFO", "1.$x", "2.#INF", "nanx", "in", "1.#IND00x",
                             "1.#INFe", "1.#INFe+", "1.#INF+000", "1.#INFe000", "1.#e+000"})
        EXPECT_FALSE(parseNumber(word)) << word;
}

struct Blemish {
    std::string text; ///< after a triangle in three lines and its face in the fourth
    std::string note; ///< or empty if the rest is as without it
    size_t triangles; ///< in all
    bool hasUvs = false;
    bool hasNormals = false;
};

// One warning with the number and the lines; the last triangle has what is left of its face.
TEST(ObjCheckTest, RendersModelsWithBlemishes) {
    const std::string few = "faces left out because they have fewer than 3 corners: ";
    const std::string left = "faces left out because a position that they name ";
    const std::string noUvs = "faces without texture coordinates because one that they name ";
    const std::string flat = "faces shown flat because a normal that they name ";
    const std::string beyond = "is not finite or beyond 1e9: ";
    const std::string zero = "is zero or not finite: ";
    const std::string corner =
        "faces left out because a corner cannot be read (corners are like 1, "
        "1/2, 1//3 or 1/2/3): ";
    const std::string someNormals =
        "faces whose normals were ignored because only some corners name one: ";
    const std::string colors = "colours of vertices are not rendered (a texture can show them): ";
    const std::vector<Blemish> blemishes = {
        {"f 1 2\n", few + "1 (line 5)", 1},
        {"f\nf 1\nf 1/1 2/1\n f 9 \n", few + "4 (lines 5, 6, 7, ...)", 1},
        {"f 1 2 # 3\nf 1 2 3\n", few + "1 (line 5)", 2},
        {"f 1 2 4\nf 1 2 9\n", left + "does not exist: 2 (lines 5, 6)", 1},
        {"f 1 2 0\n", left + "does not exist: 1 (line 5)", 1},
        {"f -1 -2 -4\n", left + "does not exist: 1 (line 5)", 1},
        {"f 1 2 99999999999999999999\nf 1 2 -99999999999999999999\nf 4294967297 2 3\n",
         left + "does not exist: 3 (lines 5, 6, 7)", 1},
        {"v nan 0 0\nv 0 -inf 0\nf 1 2 4\nf 1 2 5\nf 1 2 3\n",
         left + "is not finite: 2 (lines 7, 8)", 2},
        {"v 0 1.#IND 0\nf 1 2 3 4\n", left + "is not finite: 1 (line 6)", 1},
        {"f 1 2 4\nv 0 0 1e999\n", left + "is not finite: 1 (line 5)", 1},
        {"f 1/1 2/1 3/1\n", noUvs + "does not exist: 1 (line 5)", 2},
        {"vt 0 0\nf 1/1 2/1 3/0\n", noUvs + "does not exist: 1 (line 6)", 2},
        {"vt 0 0\nf 1/1 2/1 3/-2\n", noUvs + "does not exist: 1 (line 6)", 2},
        {"vt 0 0\nvt nan nan\nf 1/1 2/1 3/2\nf 1/1 2/1 3/1\n", noUvs + beyond + "1 (line 7)", 3,
         true},
        {"vt -1.#IND 0\nf 1/1 2/1 3/1\n", noUvs + beyond + "1 (line 6)", 2},
        {"vt 0 -1.1e9\nf 1/1 2/1 3/1\n", noUvs + beyond + "1 (line 6)", 2},
        {"vt 0 0\nf 1/1/1 2/1/1 3/1/1\n", flat + "does not exist: 1 (line 6)", 2, true},
        {"vn 0 0 1\nf 1//1 2//1 3//2\nf 1//1 2//1 3//1\n", flat + "does not exist: 1 (line 6)", 3,
         false, true},
        {"vn 0 0 1\nf 1//1 2//1 3//0\n", flat + "does not exist: 1 (line 6)", 2},
        {"vn 0 0 1\nvn nan 0 0\nf 1//1 2//1 3//2\n", flat + zero + "1 (line 7)", 2},
        {"vn 0 -0 0\nf 1//1 2//1 3//1\n", flat + zero + "1 (line 6)", 2},
        {"vn 1.#QNAN 1.#QNAN 1.#QNAN\nf 1//1 2//1 3//1\n", flat + zero + "1 (line 6)", 2},
        {"f 1 2 x\n", corner + "1 (line 5)", 1},
        {"f 1, 2, 3\nf 1/1/1/1 2 3\nf 1 2 3#c\nf 1 2 3.0\nf 1 2 /3\nf 1 2 3\n",
         corner + "5 (lines 5, 6, 7, ...)", 2},
        {"v 0 0 5#c\nv 0 1\nf 1 2 4\nf 1 2 5\nf 1 2 3\n",
         left + "cannot be read: 2 (lines 7, 8); line 5: \"5#c\" is not a number", 2},
        {"v 1 0 0 red\nf 1 2 4\n",
         left + "cannot be read: 1 (line 6); line 5: \"red\" is not a "
                "number",
         1},
        {"vt abc\nvt 0 0\nf 1/2 2/2 3/1\nf 1/2 2/2 3/2\n",
         noUvs + "cannot be read: 1 (line 7); line 5: \"abc\" is not a number", 3, true},
        {"vn 0 1\nf 1//1 2//1 3//1\n",
         flat + "cannot be read: 1 (line 6); line 5: a normal needs 3 numbers, not 2", 2},
        {"vn 0 0 1\nf 1//1 2//1 3\nf 1 2//1 3\n", someNormals + "2 (lines 6, 7)", 3},
        {"vn 0 0 1\ns 1\nf 1//1 2 3\n", someNormals + "1 (line 7)", 2, false, true}, // smoothed
        {"vt 0 0\nf 1/1 2/1 3\n",
         "faces without texture coordinates because only some corners name one: 1 (line 6)", 2},
        {"vc 1 0 0\nvc 1 0 0\n", colors + "2 (lines 5, 6)", 1},
        {"V 0 0 1 1 0 0\nF 1 2 4\n", colors + "1 (line 5)", 2},
        {"p 1\nl 1 2\nl 2 3\ncstype bezier\ncurv 0 1 1 2\nsurf 0 1 0 1 1 2 3\nend\nf 1 2 3\n",
         "statements that are not rendered, \"p\", \"l\", \"curv\", \"surf\": 5 (lines 5, 6, 7, "
         "...)",
         2},
        {"v 0 0 1 1 0 0\nv 0 1 1 1 0 0\nv 1 1 1 1.0 0.5 0.5 0.5\nf 4 5 6\n",
         "colours of vertices are not rendered (a texture can show them): 3 (lines 5, 6, 7)", 2},
        {"#MRGB ffffffff\n",
         "colours of vertices are not rendered (a texture can show them): 1 (line 5)", 1},
    };
    for (const Blemish& blemish : blemishes) {
        SCOPED_TRACE(blemish.text);
        const std::string text = kTriangle + "f 1 2 3\n" + blemish.text;
        EXPECT_EQ(notesOf(text), std::vector<std::string>{blemish.note});
        const ObjFile obj = parseObj(text, "a.obj");
        ASSERT_EQ(obj.triangles.size(), blemish.triangles);
        EXPECT_EQ(obj.triangles.back().uv[0] != Mesh::kNoUv, blemish.hasUvs);
        EXPECT_EQ(obj.triangles.back().normal[0] != Mesh::kNoNormal, blemish.hasNormals);
        for (uint32_t k = 0; k < 3; ++k)
            EXPECT_EQ(obj.triangles.front().position[k], k);
    }
}

TEST(ObjCheckTest, KeywordsMayBeInCapitals) {
    const ObjFile obj = parseObj("MTLLIB a.mtl\nV 0 0 0\nV 1 0 0\nV 0 1 2\nVT 0.25 0.5\nVN 0 0 1\n"
                                 "USEMTL m\nF 1/1/1 2/1/1 3/1/1\nS 1\nF 1 2 3\n",
                                 "a.obj");
    EXPECT_TRUE(obj.notes.empty());
    EXPECT_EQ(obj.libraries, std::vector<std::string>{"a.mtl"});
    EXPECT_EQ(obj.materialNames, std::vector<std::string>{"m"});
    ASSERT_EQ(obj.triangles.size(), 2u);
    EXPECT_EQ(obj.positions.at(2), glm::dvec3(0, 1, 2));
    EXPECT_EQ(obj.uvs.at(0), glm::dvec2(0.25, 0.5));
    EXPECT_EQ(obj.normals.at(0), glm::dvec3(0, 0, 1));
    EXPECT_EQ(obj.triangles[0].normal[0], 0u);
    EXPECT_GT(obj.triangles[1].normal[0], 0u); // of the smoothing group
}

// Faces left out must not shift the materials and smoothing groups of those that follow.
TEST(ObjCheckTest, FacesKeepTheirMaterialsBesideFacesLeftOut) {
    const ObjFile obj =
        parseObj(kTriangle + "usemtl a\nf 1 2\nf 1 x 3\nf 1 2 7\nf 1 2 3\nusemtl b\nf 1 2\n"
                             "f 1 2 8\nf 1 2 3,\ns 1\nf 1 2 3\n",
                 "a.obj");
    ASSERT_EQ(obj.triangles.size(), 2u);
    EXPECT_EQ(obj.materialNames.at(obj.triangles[0].material), "a");
    EXPECT_EQ(obj.materialNames.at(obj.triangles[1].material), "b");
    EXPECT_EQ(obj.triangles[0].normal[0], Mesh::kNoNormal);
    EXPECT_NE(obj.triangles[1].normal[0], Mesh::kNoNormal);
}

struct Refusal {
    std::string text;
    std::string fragment;
};

TEST(ObjCheckTest, RefusesModelsOfWhichNoFaceIsLeft) {
    const std::string left = "no face can be rendered: faces left out because a position that they "
                             "name cannot be read: 1 (line 4); line 2: ";
    const std::string corner = "no face can be rendered: faces left out because a corner cannot be "
                               "read (corners are like 1, 1/2, 1//3 or 1/2/3): 1 (line ";
    const std::vector<Refusal> refusals = {
        {"v 0 0 0\nv 1 0 abc\nv 0 1 0\nf 1 2 3\n", left + "\"abc\" is not a number"},
        {"v 0 0 0\nv 1 0 1,5\nv 0 1 0\nf 1 2 3\n", left + "\"1,5\" is not a number"},
        {"v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", left + "a position needs 3 numbers, not 2"},
        {"v 0 0 0\nv\nv 0 1 0\nf 1 2 3\n", left + "\"v\" lacks its numbers"},
        {"f 1 2 3\nv 0 0 0\nv 1 0 x\nv 0 1 0\n", "1 (line 1); line 3: \"x\" is not a number"},
        {kTriangle + "f 1 2 3x\n", corner + "4)"},
        {kTriangle + "\n\nf 1 \\\n2 \\\nx\n", corner + "6)"},
        {"v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 x\r", corner + "4)"},
        {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 x\r\n", corner + "4)"},
        {kTriangle + "f 1 2\nf\n", "no face can be rendered: faces left out because they have "
                                   "fewer than 3 corners: 2 (lines 4, 5)"},
        {kTriangle + "f 1 2 4\n", "no face can be rendered: faces left out because a position"},
        {"v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "is not finite: 1 (line 4)"},
        {kTriangle + "l 1 2\n", "the file has no faces; points, lines and curves"},
    };
    for (const Refusal& refusal : refusals) {
        const SceneError error = test::errorOf([&] { parseObj(refusal.text, "a.obj"); });
        EXPECT_EQ(error.where(), "a.obj") << refusal.text;
        EXPECT_NE(std::string(error.what()).find(refusal.fragment), std::string::npos)
            << error.what();
    }
}

TEST(TimedObjCheckTest, TakesTimeInProportion) {
    const auto secondsFor = [](const std::string& text) {
        return test::processorSeconds([&] {
            try {
                parseObj(text, "a.obj");
            } catch (const SceneError&) {
            }
        });
    };
    std::string carriageReturns;
    std::string continuations = "f";
    std::string garbage = kTriangle + "f 1 2 3\n";
    std::string blemishes = kTriangle + "f 1 2 3\n";
    for (int i = 0; i < 200'000; ++i) {
        carriageReturns += "v 0 0 0\r";
        continuations += " 1 \\\n";
        garbage += "v x\n";
        blemishes += "v nan 0 0\nf 1 2\nf 1 2 -1\nf 1 2 0\ns " + std::to_string(i) + "\nl 1 2\n";
    }
    EXPECT_LT(secondsFor(carriageReturns), 1.0);
    EXPECT_LT(secondsFor(continuations), 1.0);
    EXPECT_LT(secondsFor(garbage), 1.0);
    EXPECT_LT(secondsFor(blemishes), 2.0);
    EXPECT_LT(secondsFor(std::string(10'000'000, 'f')), 1.0);
}

// The caller can end the reading of a large file in each of its parts.
TEST(ObjCheckTest, EndsWhereItsProgressThrows) {
    std::string text = kTriangle + "vt nan\nf 1/1 2/1 3\n";
    for (int i = 0; i < 200'000; ++i)
        text += "v 0 0 0\nf 1 2 3 # 4\n";
    std::vector<double> steps;
    parseObj(text, "a.obj", [&](double done) { steps.push_back(done); });
    EXPECT_TRUE(std::ranges::is_sorted(steps));
    EXPECT_GT(steps.size(), 30u);
    EXPECT_LE(steps.back(), 1.0);
    for (const double end : {0.01, 0.2, 0.4, 0.55, 0.7, 0.85, 0.95}) {
        double last = 0.0;
        EXPECT_THROW(parseObj(text, "a.obj",
                              [&](double done) {
                                  last = done;
                                  if (done >= end)
                                      throw Interrupted();
                              }),
                     Interrupted);
        EXPECT_LT(last, end + 0.15);
    }
}

} // namespace
} // namespace calotype
