// Meshes in scenes: materials from the scene and from MTL files, normals, degenerate triangles.

#include <cmath>

#include <glm/geometric.hpp>

#include "scene_files.h"

namespace calotype::test {
namespace {

const char* const kTwoMaterials = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                  "usemtl seat\nf 1 2 3\nusemtl leg\nf 1 3 4\n";

class SceneMeshTest : public testing::Test {
protected:
    Scene load(const std::string& shapeKeys) {
        return files_.load(
            sceneWithShape("{\"type\": \"mesh\", \"file\": \"m.obj\"" + shapeKeys + "}"));
    }

    Mesh loadMesh(const std::string& shapeKeys = ", \"material\": \"wall\"") {
        return std::get<Mesh>(load(shapeKeys).shapes.at(0).geometry);
    }

    SceneError errorOfLoading(const std::string& shapeKeys) {
        return errorOf([&] { load(shapeKeys); });
    }

    /// The material of the triangle `index` of the only shape.
    static const Material& materialOf(const Scene& scene, size_t index) {
        return scene.materials.at(
            std::get<Mesh>(scene.shapes.at(0).geometry).triangles.at(index).material);
    }

    SceneFiles files_;
};

bool hasWarning(const Scene& scene, const std::string& fragment) {
    for (const std::string& warning : scene.warnings)
        if (warning.find(fragment) != std::string::npos)
            return true;
    return false;
}

TEST_F(SceneMeshTest, FilesOfOtherKindsAreNamedForWhatTheyAre) {
    std::string utf16 = "\xff\xfe";
    for (const char c : std::string(kTwoMaterials))
        utf16 += {c, '\0'};
    const std::pair<std::string, const char*> files[] = {
        {"ply\nformat ascii 1.0\nelement vertex 3\nend_header\n0 0 0\n", "a PLY mesh"},
        {"solid cube\nfacet normal 0 0 1\nvertex 0 0 0\n", "an STL mesh"},
        {"glTF\2", "a binary glTF file"},
        {"{\"asset\": {\"version\": \"2.0\"}}", "a JSON file"},
        {utf16, "a UTF-16 text"},
        {"# Blender MTL File\r\n\r\nnewmtl a\nKd 1 1 1\n", "an MTL material library"},
        {"", "an empty file"}};
    for (const auto& [text, kind] : files) {
        files_.write("m.obj", text);
        const SceneError error = errorOfLoading("");
        expectError(error, "m.obj", std::string("is ") + kind);
        expectError(error, "m.obj", "a mesh must be a Wavefront OBJ, a text in UTF-8");
    }
    files_.write("m.obj", "# no statement");
    expectError(errorOfLoading(""), "m.obj", "no vertices");
    // A strange first line does no harm.
    files_.write("m.obj", std::string("solid cube\n") + kTwoMaterials);
    EXPECT_EQ(loadMesh().triangles.size(), 2u);
}

TEST_F(SceneMeshTest, AWarningNamesTheKindOfAnMtlThatIsNone) {
    files_.write("m.obj", kTwoMaterials);
    files_.write("m.mtl", std::string("\xff\xfen\0e\0w\0m\0t\0l\0", 14));
    EXPECT_TRUE(hasWarning(load(""), "m.mtl: is a UTF-16 text, which has no materials"));
}

TEST_F(SceneMeshTest, OneMaterialForTheWholeNeedsNoMtl) {
    files_.write("m.obj", kTwoMaterials);
    const Scene scene = load(", \"material\": \"wall\"");
    EXPECT_EQ(materialOf(scene, 0).name, "wall");
    EXPECT_EQ(materialOf(scene, 1).name, "wall");
    EXPECT_EQ(scene.materials.size(), 1u);
}

TEST_F(SceneMeshTest, MaterialsByTheNamesOfTheObj) {
    files_.write("m.obj", kTwoMaterials);
    nlohmann::json scene = sceneWithShape(
        R"({"type": "mesh", "file": "m.obj", "materials": {"leg": "oak", "*": "wall"}})");
    scene["materials"]["oak"] = {{"type", "diffuse"}, {"color", 0.1}};
    const Scene loaded = files_.load(scene);
    EXPECT_EQ(materialOf(loaded, 0).name, "wall");
    EXPECT_EQ(materialOf(loaded, 1).name, "oak");
}

TEST_F(SceneMeshTest, MaterialKeysMustFitTheObj) {
    files_.write("m.obj", kTwoMaterials);
    expectError(errorOfLoading(R"(, "materials": {"saet": "wall", "*": "wall"})"),
                "scene.json: /shapes/0/materials/saet", "its faces have \"seat\", \"leg\"");
    expectError(errorOfLoading(R"(, "materials": {"*": "wal"})"),
                "scene.json: /shapes/0/materials/*", "did you mean \"wall\"?");
}

TEST_F(SceneMeshTest, MaterialsThatAreNotNamedAreThoseOfTheMtl) {
    files_.write("m.obj", std::string(kTwoMaterials) + "usemtl\nf 1 2 4\n");
    // The material that the scene replaces is not made: its statement gives no warning.
    files_.write("m.mtl", "newmtl seat\nrefl 1\nnewmtl leg\nKd 0.25\n");
    const Scene scene = load(R"(, "materials": {"seat": "wall"})");
    EXPECT_EQ(materialOf(scene, 0).name, "wall");
    EXPECT_EQ(materialOf(scene, 1).color, glm::dvec3(0.25));
    EXPECT_EQ(materialOf(scene, 2).color, glm::dvec3(0.5));
    EXPECT_EQ(scene.materials.size(), 3u);
    EXPECT_FALSE(hasWarning(scene, "m.obj"));
    // Another mesh of the same OBJ shares what there is and adds what it lacks.
    nlohmann::json two =
        sceneWithShape(R"({"type": "mesh", "file": "m.obj", "materials": {"seat": "wall"}})");
    two["shapes"].push_back({{"type", "mesh"}, {"file", "m.obj"}});
    const Scene both = files_.load(two);
    const auto& whole = std::get<Mesh>(both.shapes.at(1).geometry);
    EXPECT_EQ(whole.triangles[1].material,
              std::get<Mesh>(both.shapes.at(0).geometry).triangles[1].material);
    EXPECT_EQ(both.materials.at(whole.triangles[0].material).name, "m.obj:seat");
    EXPECT_EQ(both.materials.size(), 4u);
}

TEST_F(SceneMeshTest, MaterialKeysMayLeaveOutComments) {
    files_.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl leg # left\nf 1 2 3\nusemtl a #2\n"
                          "f 1 2 3\nusemtl a #3\nf 1 2 3\n");
    const Scene scene = load(R"(, "materials": {"leg": "wall", "a #2": "wall", "a": "wall"})");
    for (const size_t triangle : {0u, 1u, 2u})
        EXPECT_EQ(materialOf(scene, triangle).name, "wall");
}

TEST_F(SceneMeshTest, MtlGivesColourAndEmission) {
    files_.write("m.obj", kTwoMaterials);
    files_.write("m.mtl", "A title without its mark\nnewmtl leg\nKd 0.1 0.2 0.3\nKe 4\n\n"
                          "newmtl seat\r\n\tKd 0.5 2 0.5\r\nKs 0 0 0\nd 1\nillum 2\nNs 3\n");
    const Scene scene = load("");
    EXPECT_EQ(materialOf(scene, 0).color, glm::dvec3(0.5, 1.0, 0.5));
    EXPECT_EQ(materialOf(scene, 0).name, "m.obj:seat");
    EXPECT_EQ(materialOf(scene, 1).color, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(materialOf(scene, 1).emission, glm::dvec3(4.0));
    EXPECT_TRUE(hasWarning(scene, "m.obj: Kd above 1 was lowered to 1 in \"seat\""));
    EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST_F(SceneMeshTest, OneWarningNamesUnsupportedStatementsOfTheMtl) {
    files_.write("m.obj", kTwoMaterials);
    files_.write("m.mtl",
                 "newmtl leg\nKd 0.1\nmap_Ks oak.png\nrefl 0.5 0.5 0.5\nnewmtl seat\nPc 0.5\n"
                 "refl 1\nnewmtl unused\nmap_Ns x.png\n");
    const Scene scene = load("");
    EXPECT_TRUE(hasWarning(scene, "m.obj: these MTL statements are not supported and were "
                                  "ignored: \"Pc\", \"map_Ks\", \"refl\""));
}

TEST_F(SceneMeshTest, UndefinedMaterialsAreGreyWithAWarning) {
    files_.write("m.obj", kTwoMaterials);
    const Scene missing = load("");
    EXPECT_EQ(materialOf(missing, 0).color, glm::dvec3(0.5));
    EXPECT_EQ(materialOf(missing, 0).name, "m.obj:seat");
    EXPECT_TRUE(hasWarning(missing, "m.obj: cannot read \"m.mtl\""));
    EXPECT_TRUE(hasWarning(missing, "m.obj: a neutral grey stands for the undefined material in "
                                    "\"seat\", \"leg\" (used from line 7 on)"));
    files_.write("m.mtl", "newmtl seet\nKd 1\nnewmtl leg\nKd 1\n");
    const Scene misspelt = load("");
    EXPECT_EQ(materialOf(misspelt, 0).color, glm::dvec3(0.5));
    EXPECT_TRUE(hasWarning(misspelt, "in \"seat\" (used from line 7 on); did you mean \"seet\"?"));
    files_.write("m.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    const Scene scene = load("");
    EXPECT_EQ(materialOf(scene, 0).color, glm::dvec3(0.5));
}

TEST_F(SceneMeshTest, MtlNamesMayContainBlanks) {
    files_.write("m.obj",
                 "mtllib none.mtl my\\ own.mtl\nmtllib a b.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\n"
                 "usemtl x\nf 1 2 3\nusemtl y y\nf 1 2 3\n");
    files_.write("my own.mtl", "newmtl x\nKd 0.25\n");
    files_.write("a b.mtl", "newmtl y y\nKd 0.75\nnewmtl x\nKd 0\n");
    const Scene scene = load("");
    EXPECT_EQ(materialOf(scene, 0).color, glm::dvec3(0.25));
    EXPECT_EQ(materialOf(scene, 1).color, glm::dvec3(0.75));
}

TEST_F(SceneMeshTest, DegenerateTrianglesAreDroppedAndCounted) {
    files_.write("m.obj",
                 "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1e-170\nv 1e-170 0 0\n"
                 "f 1 2 3\nf 1 2 5\nf 4 4 1\nf 1 2 4\nf 1 6 7\n");
    const Scene scene = load(", \"material\": \"wall\"");
    const Mesh& mesh = std::get<Mesh>(scene.shapes.at(0).geometry);
    // The last is tiny, but a triangle.
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(scene.droppedTriangles, 3u);
    EXPECT_TRUE(hasWarning(scene, "m.obj: triangles left out because they have no area: 3"));
    EXPECT_EQ(mesh.positions.size(), 5u); // only those in use
    files_.write("m.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    expectError(errorOfLoading(", \"material\": \"wall\""), "scene.json: /shapes/0/file",
                "no triangle of this shape has an area");
}

TEST_F(SceneMeshTest, NormalsAreTransformedByTheInverseTranspose) {
    // A normal along (1, 1, 0), where X is stretched by 2: (1/2, 1, 0), made one long.
    files_.write("m.obj", "v 0 0 0\nv 0 0 1\nv 1 -1 0\nvn 3 3 0\nf 1//1 2//1 3//1\n");
    const Mesh stretched = loadMesh(R"(, "material": "wall", "transform": {"scale": [2, 1, 1]})");
    ASSERT_EQ(stretched.normals.size(), 1u);
    EXPECT_NEAR(stretched.normals[0].x, 1.0 / std::sqrt(5.0), 1e-15);
    EXPECT_NEAR(stretched.normals[0].y, 2.0 / std::sqrt(5.0), 1e-15);
    const Mesh mirrored = loadMesh(R"(, "material": "wall", "transform": {"scale": [-2, 1, 1]})");
    EXPECT_NEAR(mirrored.normals[0].x, -1.0 / std::sqrt(5.0), 1e-15);
    EXPECT_NEAR(mirrored.normals[0].y, 2.0 / std::sqrt(5.0), 1e-15);
    const auto& p = mirrored.triangles[0].position;
    const glm::dvec3 front = glm::cross(mirrored.positions[p[1]] - mirrored.positions[p[0]],
                                        mirrored.positions[p[2]] - mirrored.positions[p[0]]);
    EXPECT_GT(glm::dot(front, mirrored.normals[0]), 0.0);
}

TEST_F(SceneMeshTest, SmoothNormalsAreWeightedByArea) {
    // Two right angles at an edge on Z, of areas 1/2 (facing +Y) and 1 (facing +X), whose shared
    // positions are written twice.
    files_.write("m.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n"
                          "v 0 0 0\nv 0 -2 0\nv 0 0 1\nvn 0 0 1\nf 4//1 5//1 6//1\n");
    const Mesh mesh = loadMesh(R"(, "material": "wall", "normals": "smooth")");
    const auto normalOf = [&](size_t triangle, int corner) {
        return mesh.normals.at(mesh.triangles.at(triangle).normal[corner]);
    };
    EXPECT_EQ(normalOf(0, 2), glm::dvec3(0, 1, 0));
    const glm::dvec3 shared = normalOf(0, 0);
    EXPECT_EQ(shared, normalOf(1, 0));
    EXPECT_EQ(normalOf(0, 1), normalOf(1, 2));
    EXPECT_NEAR(std::abs(shared.x / shared.y), 2.0, 1e-15);
    const Mesh flat = loadMesh(R"(, "material": "wall", "normals": "flat")");
    EXPECT_EQ(flat.triangles[1].normal[0], Mesh::kNoNormal);
    EXPECT_TRUE(flat.normals.empty());
    EXPECT_EQ(loadMesh().triangles[1].normal[0], 0u);
    EXPECT_EQ(loadMesh().triangles[0].normal[0], Mesh::kNoNormal);
}

TEST_F(SceneMeshTest, SmoothNormalsThatCancelLeaveTheFaceFlat) {
    files_.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n");
    const Mesh mesh = loadMesh(R"(, "material": "wall", "normals": "smooth")");
    EXPECT_EQ(mesh.triangles[0].normal[0], Mesh::kNoNormal);
}

TEST_F(SceneMeshTest, ReportsProgressByFileName) {
    files_.write("m.obj", kTwoMaterials);
    LoadOptions options;
    std::vector<double> shares;
    options.onProgress = [&](const std::string& what, double done) {
        EXPECT_EQ(what, "m.obj");
        shares.push_back(done);
    };
    files_.load(sceneWithShape(R"({"type": "mesh", "file": "m.obj", "material": "wall"})"),
                options);
    ASSERT_GE(shares.size(), 2u);
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

} // namespace
} // namespace calotype::test
