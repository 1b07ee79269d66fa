// Displacement as scenes request it: on meshes and on materials.

#include <cmath>

#include <glm/geometric.hpp>

#include "json_context_fixture.h"

namespace calotype::test {
namespace {

class SceneDisplacedMeshTest : public testing::Test, protected JsonContextFixture {
protected:
    SceneDisplacedMeshTest() {
        // The height of "opaque" is 128 / 255 everywhere.
        readMaterialsFrom(R"({"plain": {"type": "diffuse", "color": 1},
            "raised": {"type": "diffuse", "color": 1,
                       "displacement": {"texture": "opaque", "scale": 2.55, "subdivide": 1}}})");
        files.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                             "f 1/1 4/4 3/3 2/2\n");
        files.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n");
    }

    Mesh read(const std::string& keys, const std::string& file = "m.obj") {
        const std::string shape = R"({"type": "mesh", "file": ")" + file + "\", " + keys + "}";
        return std::get<Mesh>(readShape(shape).geometry);
    }

    /// Of all positions, which lie in one plane y = constant.
    static double heightOf(const Mesh& mesh) {
        for (const glm::dvec3& p : mesh.positions)
            EXPECT_NEAR(p.y, mesh.positions[0].y, 1e-15);
        return mesh.positions.at(0).y;
    }
};

constexpr const char* kOwn = R"(, "displacement": {"texture": "opaque", "scale": -5.1,
                                                   "subdivide": 2})";

TEST_F(SceneDisplacedMeshTest, ByItsMaterial) {
    const Mesh mesh = read(R"("material": "raised")");
    EXPECT_EQ(mesh.triangles.size(), 8u);
    EXPECT_NEAR(heightOf(mesh), 1.28, 1e-15);
    EXPECT_EQ(mesh.uvs.size(), 9u);
    EXPECT_EQ(mesh.triangles[0].material, 1u);
    EXPECT_EQ(read(R"("material": "plain")").triangles.size(), 2u);
}

TEST_F(SceneDisplacedMeshTest, ByItsOwnBeforeItsMaterials) {
    for (const char* material : {"raised", "plain"}) {
        const Mesh mesh = read("\"material\": \"" + std::string(material) + "\"" + kOwn);
        EXPECT_EQ(mesh.triangles.size(), 32u);
        EXPECT_NEAR(heightOf(mesh), -2.56, 1e-14);
    }
}

TEST_F(SceneDisplacedMeshTest, InObjectSpace) {
    const Mesh mesh = read(R"("material": "raised",
                              "transform": {"scale": [1, -3, 1], "translate": [0, 10, 0]})");
    EXPECT_NEAR(heightOf(mesh), 10.0 - 3.0 * 1.28, 1e-14);
    // Mirrored: the front stays up the surface's own normal, which now points down.
    const Mesh::Triangle& t = mesh.triangles.at(0);
    const glm::dvec3 a = mesh.positions.at(t.position[0]);
    EXPECT_LT(
        glm::cross(mesh.positions.at(t.position[1]) - a, mesh.positions.at(t.position[2]) - a).y,
        0.0);
    EXPECT_EQ(mesh.normals.at(t.normal[0]), glm::dvec3(0, -1, 0));
}

TEST_F(SceneDisplacedMeshTest, IsSmoothUnlessItIsSetToFlat) {
    EXPECT_NE(read(R"("material": "raised")").triangles.at(0).normal[0], Mesh::kNoNormal);
    const Mesh flat = read(R"("material": "raised", "normals": "flat")");
    EXPECT_EQ(flat.triangles.at(0).normal[0], Mesh::kNoNormal);
    EXPECT_NE(read(R"("material": "raised", "normals": "smooth")").triangles.at(0).normal[0],
              Mesh::kNoNormal);
}

TEST_F(SceneDisplacedMeshTest, MistakesAreErrorsAtTheirPlaces) {
    expectError(
        errorOf([&] { read(R"("material": "plain", "displacement": {"texture": "opaque"})"); }),
        "scene.json: /shapes/0/displacement", "lacks \"scale\"");
    expectError(errorOf([&] {
                    read(R"("material": "plain", "displacement": {"texture": "opaque",
                            "scale": 1, "subdivide": 12})");
                }),
                "scene.json: /shapes/0/displacement/subdivide",
                "the 2 triangles of \"" + files.path("m.obj") +
                    "\" would become 33554432, above the limit of 16777216; lower");
    expectError(errorOf([&] {
                    read(R"("material": "plain", "displacement": {"texture": "opaque",
                            "scale": 1e308, "mid": -9})");
                }),
                "scene.json: /shapes/0/file", "beyond the range of finite numbers");
}

TEST_F(SceneDisplacedMeshTest, WarnsWhereItReadsMissingCoordinates) {
    EXPECT_NEAR(heightOf(read(R"("material": "raised")", "bare.obj")), 1.28, 1e-15);
    ASSERT_EQ(context.warnings.sentences().size(), 1u);
    EXPECT_NE(context.warnings.sentences()[0].find("\"raised\" lack texture coordinates"),
              std::string::npos);
    EXPECT_NEAR(heightOf(read(std::string(R"("material": "plain")") + kOwn, "bare.obj")), -2.56,
                1e-14);
    ASSERT_EQ(context.warnings.sentences().size(), 1u);
    EXPECT_NE(context.warnings.sentences()[0].find("(and 1 more of this kind, at "),
              std::string::npos);
}

TEST_F(SceneDisplacedMeshTest, OtherShapesStayAndAreWarnedOf) {
    readShape(R"({"type": "sphere", "radius": 1, "material": "raised"})");
    readShape(R"({"type": "sphere", "radius": 1, "material": "plain"})");
    ASSERT_EQ(context.warnings.sentences().size(), 1u);
    EXPECT_EQ(context.warnings.sentences()[0],
              "/scene.json: /shapes/0: the displacement of the material \"raised\" moves meshes "
              "only; this shape stays as it is");
}

} // namespace
} // namespace calotype::test
