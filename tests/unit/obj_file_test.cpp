// From the text of an OBJ to triangles, and the cutting of polygons by itself.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.h"
#include "mesh/triangulate.h"
#include "read/obj/obj_file.h"
#include "scene_files.h"

namespace calotype {
namespace {

/// Twice the sum of the triangles' signed areas seen from +Z.
double doubleAreaOf(const std::vector<glm::dvec3>& polygon,
                    std::span<const Triangulator::Triangle> triangles, bool absolute) {
    double sum = 0.0;
    for (const auto& t : triangles) {
        const glm::dvec3 a = polygon[t[0]];
        const double area = glm::cross(polygon[t[1]] - a, polygon[t[2]] - a).z;
        sum += absolute ? std::abs(area) : area;
    }
    return sum;
}

double doubleAreaOf(const std::vector<glm::dvec3>& polygon) {
    double sum = 0.0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = polygon[i];
        const glm::dvec3 b = polygon[(i + 1) % polygon.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

/// No triangle is turned over and together they have the polygon's area: they cover it exactly.
void expectCovered(const std::vector<glm::dvec3>& polygon) {
    Triangulator triangulator;
    const auto triangles = triangulator.triangulate(polygon);
    EXPECT_TRUE(triangulator.sound());
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    const double area = doubleAreaOf(polygon);
    EXPECT_NEAR(doubleAreaOf(polygon, triangles, false), area, 1e-12 * std::abs(area));
    EXPECT_NEAR(doubleAreaOf(polygon, triangles, true), std::abs(area), 1e-12 * std::abs(area));
}

TEST(ObjTriangulateTest, ConvexPolygonsBecomeFans) {
    std::vector<glm::dvec3> octagon;
    for (int i = 0; i < 8; ++i) {
        octagon.emplace_back(std::cos(i * std::numbers::pi / 4), std::sin(i * std::numbers::pi / 4),
                             0.0);
    }
    Triangulator triangulator;
    const auto triangles = triangulator.triangulate(octagon);
    ASSERT_EQ(triangles.size(), 6u);
    for (uint32_t i = 0; i < 6; ++i)
        EXPECT_EQ(triangles[i], (Triangulator::Triangle{0, i + 1, i + 2}));
}

TEST(ObjTriangulateTest, ConcavePolygonsAreCoveredFromEveryStart) {
    const std::vector<std::vector<glm::dvec3>> polygons = {
        {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1.9, 0.1, 0}}, // arrow head
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0}, {3, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}},
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}, // corners in line
        {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {1, 1, 0}, {2, 1, 0}, {1, 0.5, 0}, {0, 3, 0}},
        // A hole, joined to the outside by a seam that runs both ways.
        {{0, 0, 0},
         {4, 0, 0},
         {4, 4, 0},
         {0, 4, 0},
         {0, 0, 0},
         {1, 1, 0},
         {1, 3, 0},
         {3, 3, 0},
         {3, 1, 0},
         {1, 1, 0}},
    };
    for (const auto& polygon : polygons) {
        for (size_t start = 0; start < polygon.size(); ++start) {
            std::vector<glm::dvec3> turned(polygon.begin() + start, polygon.end());
            turned.insert(turned.end(), polygon.begin(), polygon.begin() + start);
            SCOPED_TRACE("polygon of " + std::to_string(polygon.size()) + " from corner " +
                         std::to_string(start));
            expectCovered(turned);
            expectCovered({turned.rbegin(), turned.rend()});
        }
    }
}

TEST(ObjTriangulateTest, FoldedQuadsAreCutWhereTheirHalvesAgree) {
    // A roof whose ridge runs from corner 1 to corner 3.
    Triangulator triangulator;
    const std::vector<glm::dvec3> roof = {{0, 0, 0}, {1, 0, 5}, {2, 0, 0}, {1, 1, 5}};
    const auto triangles = triangulator.triangulate(roof);
    ASSERT_EQ(triangles.size(), 2u);
    EXPECT_EQ(triangles[0], (Triangulator::Triangle{0, 1, 3}));
    EXPECT_EQ(triangles[1], (Triangulator::Triangle{1, 2, 3}));
}

TEST(ObjTriangulateTest, SizeDoesNotMatter) {
    for (const double scale : {1e-170, 1e-300, 1e150, 1e300}) {
        std::vector<glm::dvec3> polygon = {{0, 0, 0}, {2, 0, 0},   {2, 2, 0},
                                           {1, 2, 0}, {1, 0.5, 0}, {0, 2, 0}};
        Triangulator triangulator;
        const auto unit = triangulator.triangulate(polygon);
        const std::vector<Triangulator::Triangle> expected(unit.begin(), unit.end());
        for (glm::dvec3& p : polygon)
            p *= scale;
        const auto scaled = triangulator.triangulate(polygon);
        EXPECT_TRUE(triangulator.sound()) << scale;
        EXPECT_TRUE(std::equal(scaled.begin(), scaled.end(), expected.begin(), expected.end()))
            << scale;
    }
}

TEST(ObjTriangulateTest, KeepsAllCornersOfPolygonsThatCrossThemselves) {
    Triangulator triangulator;
    std::vector<glm::dvec3> pentagram;
    for (int i = 0; i < 5; ++i) {
        pentagram.emplace_back(std::cos(i * 0.8 * std::numbers::pi),
                               std::sin(i * 0.8 * std::numbers::pi), 0.0);
    }
    EXPECT_EQ(triangulator.triangulate(pentagram).size(), 3u);
    EXPECT_FALSE(triangulator.sound());
    const std::vector<glm::dvec3> point(7, glm::dvec3(1.0));
    EXPECT_EQ(triangulator.triangulate(point).size(), 5u);
}

TEST(ObjTriangulateTest, HugeRaggedPolygonsTakeBoundedTime) {
    const int teeth = 200'000;
    std::vector<glm::dvec3> comb;
    for (int i = 0; i < teeth; ++i)
        comb.emplace_back(i, i % 2 == 0 ? 0.0 : 1000.0 + i % 7, 0.0);
    comb.emplace_back(teeth, -1.0, 0.0);
    comb.emplace_back(-1.0, -1.0, 0.0);
    Triangulator triangulator;
    size_t triangles = 0;
    const double seconds =
        test::processorSeconds([&] { triangles = triangulator.triangulate(comb).size(); });
    EXPECT_EQ(triangles, comb.size() - 2);
    EXPECT_LT(seconds, 5.0);
}

TEST(ObjFileTest, ReadsEveryFormOfCorner) {
    const ObjFile obj =
        parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 .5e+1\nvt 0 0\nvn 0 0 2\nvn 0 1 0\n"
                 "f 1 2 3\nf -4/1 -3/1 -2/1\nf 1//1 2//2 4//-1\nf 1/1/1 2/1/1 3/1/1\n",
                 "a.obj");
    ASSERT_EQ(obj.triangles.size(), 4u);
    EXPECT_EQ(obj.positions.at(3), glm::dvec3(1, 1, 5));
    EXPECT_EQ(obj.triangles[0].position[2], 2u);
    EXPECT_EQ(obj.triangles[0].normal[0], Mesh::kNoNormal);
    EXPECT_EQ(obj.triangles[1].position[0], 0u);
    EXPECT_EQ(obj.triangles[1].normal[2], Mesh::kNoNormal);
    EXPECT_EQ(obj.triangles[2].position[2], 3u);
    EXPECT_EQ(obj.triangles[2].normal[0], 0u);
    EXPECT_EQ(obj.triangles[2].normal[2], 1u);
    EXPECT_EQ(obj.triangles[3].normal[1], 0u);
}

TEST(ObjFileTest, EmptyFieldsAreNone) {
    // tinyobjloader by itself takes the next corner's number for an empty last field.
    const ObjFile obj = parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
                                 "f 1// 2// 3//\nf 1/ 2/ 3/\nf 1/1/ 2/1/ 3/1/\n",
                                 "a.obj");
    ASSERT_EQ(obj.triangles.size(), 3u);
    for (const Mesh::Triangle& triangle : obj.triangles) {
        for (uint32_t k = 0; k < 3; ++k) {
            EXPECT_EQ(triangle.position[k], k);
            EXPECT_EQ(triangle.normal[k], Mesh::kNoNormal);
        }
    }
}

TEST(ObjFileTest, ReadsContinuedLinesCommentsAndOddEndings) {
    const std::string expected = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    for (const std::string& text :
         {expected,
          std::string("v 0 \\\n0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\r\n3 4 # quad 5\n"),
          "\xEF\xBB\xBF" + expected, std::string("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4"),
          std::string("\n\t v 0 0 0 # a\n v 1 0 0\nv 1 1 0\nv 0 1 0\n  f 1 2 3 4 # 1 2 3\n")}) {
        const ObjFile obj = parseObj(text, "a.obj");
        EXPECT_EQ(obj.positions, parseObj(expected, "b.obj").positions) << text;
        ASSERT_EQ(obj.triangles.size(), 2u) << text;
        EXPECT_EQ(obj.triangles[1].position[2], 3u) << text;
    }
}

TEST(ObjFileTest, ReadsNumbersWhoseFactorsLeaveTheRange) {
    // tinyobjloader by itself reads 0 times infinity, or overflows the exponent.
    const std::string ten400 = "1" + std::string(400, '0');
    const ObjFile obj = parseObj("v 0e999 1e-2147483648 1e+300\nv 1 " + ten400 + "e-400 0\n" +
                                     "v 1E-310 12345e-4 -1e-0002\nv x 1e2147483648 0\nf 1 2 3\n",
                                 "a.obj");
    EXPECT_EQ(obj.positions.at(0), glm::dvec3(0.0, 0.0, 1e300));
    EXPECT_EQ(obj.positions.at(1), glm::dvec3(1.0, 1.0, 0.0));
    // The smallest numbers keep fewer digits.
    EXPECT_NEAR(obj.positions.at(2).x, 1e-310, 1e-322);
    EXPECT_NEAR(obj.positions.at(2).y, 1.2345, 1e-15);
    EXPECT_EQ(obj.positions.at(2).z, -1e-2);
}

TEST(ObjFileTest, TakesNormalsOfAFaceOnlyAsAWhole) {
    const std::string start =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 0\nvn nan 1 0\n";
    const auto normalOf = [&](const std::string& face, size_t triangle) {
        return parseObj(start + face, "a.obj").triangles.at(triangle).normal[0];
    };
    EXPECT_EQ(normalOf("f 1//1 2//1 3//1 4//1\n", 1), 0u);
    EXPECT_EQ(normalOf("f 1//1 2//1 3//1 4//2\n", 0), Mesh::kNoNormal); // a zero one
    EXPECT_EQ(normalOf("f 1//1 2//1 3//1 4//3\n", 0), Mesh::kNoNormal); // not finite
    EXPECT_EQ(normalOf("f 1//1 2//1 3//1 4\n", 0), Mesh::kNoNormal);    // missing
}

TEST(ObjFileTest, FollowsMaterialsFromFaceToFace) {
    const ObjFile obj =
        parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nusemtl a b\nf 1 2 3 4\n"
                 "usemtl c\nf 1 2 3\nusemtl a b\nf 1 2 3\n",
                 "a.obj");
    EXPECT_EQ(obj.materialNames, (std::vector<std::string>{"a b", "c"}));
    EXPECT_TRUE(obj.hasFacesWithoutMaterial);
    const std::vector<uint32_t> expected = {ObjFile::kNoMaterial, 0, 0, 1, 0};
    ASSERT_EQ(obj.triangles.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(obj.triangles[i].material, expected[i]) << i;
}

TEST(ObjFileTest, RefusesFilesWithoutPolygons) {
    for (const char* text :
         {"", "# nothing\n", "solid stl\n", "v 0 0 0\np 1\n", "v 0 0 0\nl 1 1\n"}) {
        EXPECT_THROW(parseObj(text, "a.obj"), SceneError) << text;
    }
}

} // namespace
} // namespace calotype
