// Smoothing groups of OBJ files.

#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "unit/scene_files.h"
#include "unit/test_meshes.h"

namespace calotype::test {
namespace {

// Two faces that meet along the edge from (0, 0, 0) to (1, 0, 0): one of area 1/2 that faces +Z,
// one of area 1 that faces -Y.
const std::string kHinge = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -2\n";
const std::string kUpright = "f 1 2 3\n";
const std::string kLevel = "f 2 1 4\n";

constexpr glm::dvec3 kFront(0, 0, 1);
constexpr glm::dvec3 kDown(0, -1, 0);
/// Of the shared edge: the areas' sum (0, -1, 1/2).
const glm::dvec3 kBoth = glm::normalize(glm::dvec3(0, -2, 1));

/// Of a corner, numbered from 0; zero if the triangle is flat.
glm::dvec3 normalOf(const ObjFile& obj, size_t triangle, int corner) {
    const uint32_t index = obj.triangles.at(triangle).normal[corner];
    return index == Mesh::kNoNormal ? glm::dvec3(0.0) : obj.normals.at(index);
}

void expectNormals(const ObjFile& obj, size_t triangle, const std::array<glm::dvec3, 3>& expected) {
    for (int k = 0; k < 3; ++k) {
        const double distance = glm::distance(normalOf(obj, triangle, k), expected[k]);
        EXPECT_LT(distance, kRounding) << "triangle " << triangle << ", corner " << k;
    }
}

constexpr std::array<glm::dvec3, 3> kFlat = {};

TEST(SmoothingGroupTest, FacesOfOneGroupShareNormals) {
    const ObjFile obj = parseObj(kHinge + "s 1\n" + kUpright + kLevel, "a.obj");
    expectNormals(obj, 0, {kBoth, kBoth, kFront});
    expectNormals(obj, 1, {kBoth, kBoth, kDown});
    EXPECT_TRUE(obj.notes.empty());
}

TEST(SmoothingGroupTest, PositionsOfSeveralGroupsHaveANormalForEach) {
    const ObjFile obj = parseObj(kHinge + "s 1\n" + kUpright + "s 2\n" + kLevel, "a.obj");
    expectNormals(obj, 0, {kFront, kFront, kFront});
    expectNormals(obj, 1, {kDown, kDown, kDown});
}

TEST(SmoothingGroupTest, EndWithOffAndZero) {
    for (const char* end : {"s off\n", "s 0\n", "s\n"}) {
        const ObjFile obj = parseObj(kHinge + "s 1\n" + kUpright + end + kLevel, "a.obj");
        expectNormals(obj, 0, {kFront, kFront, kFront});
        expectNormals(obj, 1, kFlat);
    }
    EXPECT_TRUE(parseObj(kHinge + "s off\n" + kUpright, "a.obj").normals.empty());
}

TEST(SmoothingGroupTest, GoOnAfterOthers) {
    const ObjFile obj =
        parseObj(kHinge + "s 1\n" + kUpright + "s 2\nf 1 2 3\ns 1\n" + kLevel, "a.obj");
    expectNormals(obj, 0, {kBoth, kBoth, kFront});
    expectNormals(obj, 1, {kFront, kFront, kFront});
    expectNormals(obj, 2, {kBoth, kBoth, kDown});
}

TEST(SmoothingGroupTest, EqualPositionsAreOne) {
    const ObjFile obj =
        parseObj(kHinge + "s 1\n" + kUpright + "v 0 0 0\nv 1 0 0\nv 0 0 -2\nf -2 -3 -1\n", "a.obj");
    expectNormals(obj, 0, {kBoth, kBoth, kFront});
    expectNormals(obj, 1, {kBoth, kBoth, kDown});
}

TEST(SmoothingGroupTest, GivenNormalsStay) {
    const ObjFile obj = parseObj(kHinge + "vn 1 0 0\ns 1\nf 1//1 2//1 3//1\n" + kLevel, "a.obj");
    expectNormals(obj, 0, {glm::dvec3(1, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(1, 0, 0)});
    expectNormals(obj, 1, {kBoth, kBoth, kDown}); // the surface of the group is the same
}

TEST(SmoothingGroupTest, FacesWithBadNormalsStayFlat) {
    const ObjFile obj = parseObj(kHinge + "vn 0 0 1\ns 1\nf 1//1 2//1 3//2\n" + kLevel, "a.obj");
    expectNormals(obj, 0, kFlat);
    expectNormals(obj, 1, {kBoth, kBoth, kDown});
}

TEST(SmoothingGroupTest, NormalsThatCancelLeaveFacesFlat) {
    const ObjFile obj = parseObj(kHinge + "s 1\n" + kUpright + "f 3 2 1\ns 2\n" + kLevel, "a.obj");
    expectNormals(obj, 0, kFlat);
    expectNormals(obj, 1, kFlat);
    expectNormals(obj, 2, {kDown, kDown, kDown});
}

// Unused positions, even huge ones, do not change the rounding.
TEST(SmoothingGroupTest, UnusedPositionsDoNotMatter) {
    const ObjFile obj = parseObj("v 1e300 0 0\n" + kHinge + "s 1\nf 2 3 4\nf 3 2 5\n", "a.obj");
    expectNormals(obj, 0, {kBoth, kBoth, kFront});
}

class SmoothingModeTest : public testing::Test {
protected:
    /// The normal at the first corner of the first triangle; zero if it is flat.
    glm::dvec3 firstNormal(const std::string& obj, const std::string& keys) {
        files_.write("m.obj", obj);
        const Scene scene = files_.load(
            sceneWithShape(R"({"type": "mesh", "file": "m.obj", "material": "wall")" + keys + "}"));
        const auto& mesh = std::get<Mesh>(scene.shapes.at(0).geometry);
        const uint32_t index = mesh.triangles.at(0).normal[0];
        return index == Mesh::kNoNormal ? glm::dvec3(0.0) : mesh.normals.at(index);
    }

    SceneFiles files_;
};

TEST_F(SmoothingModeTest, TheOptionOfTheSceneIsUsedBeforeTheGroups) {
    const std::string apart = kHinge + "s 1\n" + kUpright + "s 2\n" + kLevel;
    const std::string together = kHinge + "s 1\n" + kUpright + kLevel;
    const auto expectNear = [](const glm::dvec3& normal, const glm::dvec3& expected) {
        EXPECT_LT(glm::distance(normal, expected), kRounding);
    };
    expectNear(firstNormal(together, ""), kBoth);
    expectNear(firstNormal(together, R"(, "normals": "auto")"), kBoth);
    expectNear(firstNormal(apart, ""), kFront);
    expectNear(firstNormal(apart, R"(, "normals": "smooth")"), kBoth);
    expectNear(firstNormal(together, R"(, "normals": "flat")"), glm::dvec3(0.0));
    // Mirrored and turned: a quarter about X takes -Y to -Z, and +Z to -Y.
    expectNear(
        firstNormal(together, R"(, "transform": {"rotate": [90, 0, 0], "scale": [-1, 1, 1]})"),
        glm::normalize(glm::dvec3(0, -1, -2)));
}

} // namespace
} // namespace calotype::test
