// Texture coordinates from the scene file and from OBJ files, to the corners of triangles.

#include "json_context_fixture.h"
#include "read/obj/obj_file.h"

namespace calotype::test {
namespace {

using Uvs = std::vector<glm::dvec2>;

/// Those of the corners of a triangle.
Uvs uvsOf(const Mesh& mesh, size_t triangle) {
    Uvs uvs;
    for (const uint32_t index : mesh.triangles.at(triangle).uv)
        uvs.push_back(mesh.uvs.at(index));
    return uvs;
}

/// The texture coordinates at the corner of a triangle that lies at `position`.
glm::dvec2 uvAt(const Mesh& mesh, size_t triangle, const glm::dvec3& position) {
    for (int k = 0; k < 3; ++k)
        if (mesh.positions.at(mesh.triangles.at(triangle).position[k]) == position)
            return mesh.uvs.at(mesh.triangles.at(triangle).uv[k]);
    ADD_FAILURE() << "no corner there";
    return {};
}

class SceneUvsTest : public testing::Test, protected JsonContextFixture {
protected:
    SceneUvsTest() {
        readMaterialsFrom(R"({"plain": {"type": "diffuse", "color": 1},
                              "tiled": {"type": "diffuse", "color": "tiles"}})");
    }

    Mesh read(const std::string& shape) { return std::get<Mesh>(readShape(shape).geometry); }

    static constexpr const char* kQuad =
        R"({"type": "quad", "vertices": [[0, 0, 0], [1, 0, 0], [1, 2, 0], [0, 2, 0]],
            "material": "plain")";
};

TEST_F(SceneUvsTest, PolygonsHaveThoseOfTheFormat) {
    const Mesh quad = read(std::string(kQuad) + "}");
    EXPECT_EQ(uvsOf(quad, 0), (Uvs{{0, 0}, {1, 0}, {1, 1}}));
    EXPECT_EQ(uvsOf(quad, 1), (Uvs{{0, 0}, {1, 1}, {0, 1}}));
    const Mesh triangle = read(R"({"type": "triangle", "material": "plain",
                                   "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]})");
    EXPECT_EQ(uvsOf(triangle, 0), (Uvs{{0, 0}, {1, 0}, {0, 1}}));
}

TEST_F(SceneUvsTest, PolygonsHaveThoseOfTheFile) {
    const Mesh quad =
        read(std::string(kQuad) + R"(, "uvs": [[0.5, 2], [3, -4], [5, 6.5], [7, 8]]})");
    EXPECT_EQ(uvsOf(quad, 0), (Uvs{{0.5, 2}, {3, -4}, {5, 6.5}}));
    EXPECT_EQ(uvsOf(quad, 1), (Uvs{{0.5, 2}, {5, 6.5}, {7, 8}}));
}

TEST_F(SceneUvsTest, BeyondSinglePrecisionAreErrorsWithTheirPlace) {
    const auto readWith = [&](const std::string& coordinate) {
        return read(kQuad + std::string(R"(, "uvs": [[0, 0], [1, 0], [1, 1], [0, )") + coordinate +
                    "]]}");
    };
    for (const std::string coordinate : {"1.1e9", "-1.1e9", "1e30", "1e300"}) {
        expectError(errorOf([&] { readWith(coordinate); }), "scene.json: /shapes/0/uvs/3/1",
                    "must be in [-1e+09, 1e+09]");
    }
    EXPECT_EQ(uvAt(readWith("-1e9"), 1, {0, 2, 0}), glm::dvec2(0, -1e9));
}

TEST_F(SceneUvsTest, StayWithTheirCornersInAMirror) {
    const std::string uvs = R"(, "uvs": [[1, 2], [3, 4], [5, 6], [7, 8]], "transform": )";
    const Mesh quad = read(kQuad + uvs + R"({"scale": [-1, 1, 1]}})");
    EXPECT_EQ(uvAt(quad, 0, {0, 0, 0}), glm::dvec2(1, 2));
    EXPECT_EQ(uvAt(quad, 0, {-1, 0, 0}), glm::dvec2(3, 4));
    EXPECT_EQ(uvAt(quad, 0, {-1, 2, 0}), glm::dvec2(5, 6));
    EXPECT_EQ(uvAt(quad, 1, {0, 2, 0}), glm::dvec2(7, 8));
}

TEST_F(SceneUvsTest, LightsHaveNone) {
    const Scene scene = files.load(sceneWithLight(R"({"type": "quad", "radiance": 5,
            "vertices": [[-1, 3, -1], [1, 3, -1], [1, 3, 1], [-1, 3, 1]]})"));
    const Mesh& mesh = std::get<Mesh>(scene.shapes.at(0).geometry);
    EXPECT_TRUE(mesh.uvs.empty());
    EXPECT_EQ(mesh.triangles.at(1).uv[2], Mesh::kNoUv);
}

TEST_F(SceneUvsTest, OfMeshesAreThoseInUse) {
    files.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nvt 9 9\nvt 0.5 0.25\nvt 8 8\n"
                         "vt 1 0\nvt 0 1\nf 1/1 2/1 4/3\nf 1/2 2/4 3/5\n");
    const Mesh mesh = read(R"({"type": "mesh", "file": "m.obj", "material": "plain",
                               "transform": {"scale": [1, 1, -1]}})");
    ASSERT_EQ(mesh.triangles.size(), 1u); // the first has no area
    EXPECT_EQ(mesh.uvs.size(), 3u);
    EXPECT_EQ(uvAt(mesh, 0, {0, 0, 0}), glm::dvec2(0.5, 0.25));
    EXPECT_EQ(uvAt(mesh, 0, {1, 0, 0}), glm::dvec2(1, 0));
    EXPECT_EQ(uvAt(mesh, 0, {0, 1, 0}), glm::dvec2(0, 1));
}

TEST_F(SceneUvsTest, MissingOnesAreWarnedOfWhereTexturesAreRead) {
    files.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    read(R"({"type": "mesh", "file": "m.obj", "material": "plain"})");
    EXPECT_TRUE(context.warnings.sentences().empty());
    read(R"({"type": "mesh", "file": "m.obj", "material": "tiled"})");
    ASSERT_EQ(context.warnings.sentences().size(), 1u);
    EXPECT_TRUE(context.warnings.sentences()[0].ends_with(
        "/m.obj: faces of the textured material \"tiled\" lack texture coordinates, which "
        "count as (0, 0)"))
        << context.warnings.sentences()[0];
    files.write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
    read(R"({"type": "mesh", "file": "n.obj", "material": "tiled"})");
    EXPECT_EQ(context.warnings.sentences().size(), 1u);
}

TEST(ObjUvsTest, EveryFormOfCorner) {
    const ObjFile obj = parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\n"
                                 "vt 0 0.5\nvt 1 0.25 7\nf 1/1 2/2 3/1\nvt 0.125\n"
                                 "f 1/-1 2/-2 3/-3\nf 1/3/1 2/2/1 3/1/1 4/-1/1\nf 1//1 2//1 3//1\n",
                                 "a.obj");
    ASSERT_EQ(obj.uvs, (Uvs{{0, 0.5}, {1, 0.25}, {0.125, 0}}));
    const auto expectUv = [&](size_t triangle, uint32_t a, uint32_t b, uint32_t c) {
        const auto& uv = obj.triangles.at(triangle).uv;
        EXPECT_TRUE(uv[0] == a && uv[1] == b && uv[2] == c) << triangle;
    };
    expectUv(0, 0, 1, 0);
    expectUv(1, 2, 1, 0); // counted back from where the face stands
    expectUv(2, 2, 1, 0);
    expectUv(3, 2, 0, 2);
    expectUv(4, Mesh::kNoUv, Mesh::kNoUv, Mesh::kNoUv);
    EXPECT_EQ(obj.triangles[2].normal[0], 0u);
}

TEST(ObjUvsTest, OfAFaceOnlyAsAWhole) {
    const ObjFile obj = parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\n"
                                 "f 1/1 2/1 3/1 4\nf 1/1 2/1 3/1\n",
                                 "a.obj");
    EXPECT_EQ(obj.triangles.at(0).uv[0], Mesh::kNoUv);
    EXPECT_EQ(obj.triangles.at(1).uv[2], Mesh::kNoUv);
    EXPECT_EQ(obj.triangles.at(2).uv[2], 0u);
}

} // namespace
} // namespace calotype::test
