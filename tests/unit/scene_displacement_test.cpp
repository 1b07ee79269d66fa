// Displacement: heights, directions, normals, watertightness, limits.

#include <cmath>
#include <memory>
#include <random>

#include "base/error.h"
#include "mesh/displacement.h"
#include "mesh/subdivide.h"
#include "scene_files.h"
#include "test_meshes.h"

namespace calotype::test {
namespace {

using PerMaterial = std::vector<std::optional<Displacement>>;

/// A square of side 1 in the plane y = 0, facing +Y, with texture coordinates x and z; halved from
/// (0, 0) to (1, 1).
const char* const kSquare = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                            "f 1/1 4/4 3/3\nf 1/1 3/3 2/2\n";

Texture image(uint32_t width, uint32_t height, const std::vector<float>& values,
              TextureWrap wrap = TextureWrap::Clamp) {
    TexelImage texels{width, height, {}, {}, false, false};
    for (const float value : values)
        texels.floats.insert(texels.floats.end(), {value, 0.0f, 0.0f, 1.0f});
    Texture texture;
    texture.source = ImageTexture{std::make_shared<const TexelImage>(texels), wrap};
    return texture;
}

Texture randomImage() {
    std::mt19937 random(3);
    std::vector<float> values(16 * 16);
    for (float& value : values)
        value = static_cast<float>(random() & 1023) / 1023.0f;
    return image(16, 16, values, TextureWrap::Repeat);
}

Displacement by(double scale, double mid, uint32_t subdivide) {
    return {0, scale, mid, subdivide, "scene.json: /subdivide"};
}

Mesh displaced(const std::string& text, const PerMaterial& ofMaterial, const Texture& texture) {
    const TestMesh mesh(text);
    auto result = displace(mesh.view(), ofMaterial, std::vector{texture}, "m.obj");
    EXPECT_TRUE(result);
    return result.value_or(Mesh());
}

TEST(DisplacementTest, IsNoneWhereNoMaterialHasOne) {
    const TestMesh square(kSquare);
    EXPECT_FALSE(displace(square.view(), {}, {}, "m.obj"));
    EXPECT_FALSE(displace(square.view(), PerMaterial{std::nullopt, by(1, 0, 1)}, {}, "m.obj"));
}

TEST(DisplacementTest, OfZeroLeavesTheSurface) {
    for (const Displacement& zero : {by(0.0, 0.0, 3), by(0.5, 0.25, 3)}) {
        const Mesh mesh =
            displaced(kSplitCube, {zero}, image(1, 1, {zero.scale == 0.0 ? 1.0f : 0.25f}));
        EXPECT_EQ(mesh.positions, subdivide(TestMesh(kSplitCube).view(), 3).positions);
        EXPECT_NEAR(areaOf(mesh), 24.0, sumRounding(mesh, 24.0));
        EXPECT_NEAR(volumeOf(mesh), 8.0, sumRounding(mesh, 8.0));
    }
}

TEST(DisplacementTest, OfAConstantHeightShiftsAPlane) {
    const Mesh mesh = displaced(kSquare, {by(-0.5, 0.25, 4)}, image(1, 1, {1.0f}));
    EXPECT_EQ(mesh.triangles.size(), 512u);
    EXPECT_EQ(mesh.positions.size(), 17u * 17u);
    for (const glm::dvec3& p : mesh.positions)
        EXPECT_EQ(p.y, -0.5 * (1.0 - 0.25));
    for (const Mesh::Triangle& triangle : mesh.triangles)
        for (const uint32_t normal : triangle.normal)
            EXPECT_EQ(mesh.normals.at(normal), glm::dvec3(0, 1, 0));
}

TEST(DisplacementTest, OfAConstantHeightScalesAnOctahedron) {
    const std::string octahedron = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
                                   "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\n"
                                   "f 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
    const Mesh mesh = displaced(octahedron, {by(0.5, 0.0, 0)}, image(1, 1, {0.5f}));
    EXPECT_NEAR(volumeOf(mesh), 4.0 / 3.0 * std::pow(1.25, 3), kRounding);
    EXPECT_NEAR(areaOf(mesh), 4.0 * std::sqrt(3.0) * 1.25 * 1.25, 10.0 * kRounding);
}

TEST(DisplacementTest, OfASphereApproachesTheSphereAround) {
    // Rings of latitude. Volume errors of a polyhedron shrink with the square of its edges.
    constexpr int kRings = 64;
    constexpr int kSectors = 128;
    std::string text;
    for (int i = 0; i <= kRings; ++i) {
        for (int j = 0; j < kSectors; ++j) {
            const double polar = M_PI * i / kRings;
            const double azimuth = 2.0 * M_PI * j / kSectors;
            const double r = i == 0 || i == kRings ? 0.0 : std::sin(polar);
            text += "v " + std::to_string(r * std::cos(azimuth)) + " " +
                    std::to_string(r * std::sin(azimuth)) + " " + std::to_string(std::cos(polar)) +
                    "\n";
        }
    }
    for (int i = 0; i < kRings; ++i) {
        for (int j = 0; j < kSectors; ++j) {
            const int next = (j + 1) % kSectors;
            const int a = i * kSectors + 1;
            text += "f " + std::to_string(a + j) + " " + std::to_string(a + kSectors + j) + " " +
                    std::to_string(a + kSectors + next) + "\nf " + std::to_string(a + j) + " " +
                    std::to_string(a + kSectors + next) + " " + std::to_string(a + next) + "\n";
        }
    }
    const Mesh mesh = displaced(text, {by(0.25, 0.0, 0)}, image(1, 1, {1.0f}));
    const double exact = 4.0 / 3.0 * M_PI * std::pow(1.25, 3);
    EXPECT_LT(volumeOf(mesh), exact);
    EXPECT_NEAR(volumeOf(mesh) / exact, 1.0, 0.0025); // (2 pi / 128)^2
}

TEST(DisplacementTest, OfALinearHeightTiltsAPlane) {
    // Two texels, between whose centres u = 1/4 and 3/4 the height rises from 0 to 1.
    const std::string text = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0.25 0\nvt 0.75 0\n"
                             "f 1/1 4/1 3/2\nf 1/1 3/2 2/2\n";
    const Mesh mesh = displaced(text, {by(0.75, 0.0, 5)}, image(2, 1, {0.0f, 1.0f}));
    EXPECT_NEAR(areaOf(mesh), 1.25, sumRounding(mesh, 1.25)); // 3, 4 and 5
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(corner(mesh, triangle, k).y, 0.75 * corner(mesh, triangle, k).x, kRounding);
            const glm::dvec3& normal = mesh.normals.at(triangle.normal[k]);
            EXPECT_NEAR(normal.x, -0.6, kRounding);
            EXPECT_NEAR(normal.y, 0.8, kRounding);
        }
    }
}

TEST(DisplacementTest, KeepsACubeWithSeamsWatertight) {
    Texture checker;
    checker.source = CheckerTexture{{glm::dvec3(0.0), glm::dvec3(1.0)}};
    checker.scale = {7.0, 5.0};
    for (const Texture& texture : {randomImage(), checker}) {
        const Mesh mesh = displaced(kSplitCube, {by(0.1, 0.5, 5)}, texture);
        expectWatertight(mesh);
        EXPECT_GT(areaOf(mesh), 24.5); // it has become rough
        EXPECT_NEAR(volumeOf(mesh), 8.0, 24.0 * 0.05);
    }
}

TEST(DisplacementTest, KeepsDifferentMaterialsWatertight) {
    // Three sides are displaced, differently, and three are not.
    std::string text;
    int side = 0;
    for (size_t start = 0; start < kSplitCube.size(); ++side) {
        const size_t end = kSplitCube.find('\n', kSplitCube.find('f', start)) + 1;
        std::string lines = kSplitCube.substr(start, end - start);
        lines.insert(lines.find('f'), "usemtl m" + std::to_string(side % 4) + "\n");
        text += lines;
        start = end;
    }
    ASSERT_EQ(side, 6);
    const PerMaterial ofMaterial = {by(0.2, 0.0, 1), std::nullopt, by(-0.1, 0.5, 4)};
    const Mesh mesh = displaced(text, ofMaterial, randomImage());
    EXPECT_EQ(mesh.triangles.size(), 12u << 8); // by the largest of the two
    expectWatertight(mesh);
    // The undisplaced side y = 1 stays there, but for the squares at its edges, and is flat.
    size_t inPlace = 0;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        if (triangle.material == 3) {
            EXPECT_EQ(triangle.normal[0], Mesh::kNoNormal);
            inPlace += areaVector(mesh, triangle) == glm::dvec3(0.0, 1.0 / 128.0, 0.0) ? 1 : 0;
        }
    }
    EXPECT_GE(inPlace, 2u * 14u * 14u);
    EXPECT_LT(inPlace, 2u * 16u * 16u);
}

TEST(DisplacementTest, AveragesDistinctHeightsAtAPosition) {
    // Heights are u. Four triangles around (1, 0, 1): texture coordinates of 0.5 (twice), and 0.125
    // there; the last triangle is not displaced.
    const auto heightWith = [](const std::string& last, const PerMaterial& ofMaterial) {
        const std::string text =
            "v 0 0 0\nv 2 0 0\nv 2 0 2\nv 0 0 2\nv 1 0 1\nvt 0.5 0\nvt 0.125 0\nvt 0 0\n"
            "vt 0.5 0\nusemtl a\nf 2/3 1/3 5/1\nf 3/3 2/3 5/4\nf 4/3 3/3 5/2\n" +
            last;
        std::vector<float> ramp;
        for (int i = 0; i < 8; ++i)
            ramp.push_back(static_cast<float>((i + 0.5) / 8.0));
        const Mesh mesh = displaced(text, ofMaterial, image(8, 1, ramp));
        double highest = 0.0;
        for (const glm::dvec3& p : mesh.positions)
            highest = p.x == 1.0 ? p.y : highest;
        return highest;
    };
    const Displacement whole = by(1.0, 0.0, 0);
    EXPECT_NEAR(heightWith("f 1/3 4/3 5/1\n", {whole}), (0.5 + 0.125) / 2.0, kRounding);
    EXPECT_NEAR(heightWith("usemtl b\nf 1/3 4/3 5/1\n", {whole, whole}), (0.5 + 0.125) / 2.0,
                kRounding);
    EXPECT_NEAR(heightWith("usemtl b\nf 1/3 4/3 5/1\n", {whole, by(2.0, 0.0, 0)}),
                (0.5 + 0.125 + 1.0) / 3.0, kRounding);
    EXPECT_NEAR(heightWith("usemtl b\nf 1/3 4/3 5/2\n", {whole}), (0.5 + 0.125 + 0.0) / 3.0,
                kRounding);
    // Missing coordinates count as (0, 0), where the ramp is clamped to 1/16.
    EXPECT_NEAR(heightWith("f 1 4 5\n", {whole}), (0.5 + 0.125 + 0.0625) / 3.0, kRounding);
}

TEST(DisplacementTest, LeavesPositionsWhoseNormalsCancel) {
    const Mesh mesh = displaced("v 0 0 0\nv 0.7 0 0.1\nv 0.3 0.9 0\nf 1 2 3\nf 2 1 3\n",
                                {by(1.0, 0.0, 2)}, image(1, 1, {1.0f}));
    EXPECT_EQ(mesh.positions, subdivide(TestMesh("v 0 0 0\nv 0.7 0 0.1\nv 0.3 0.9 0\n"
                                                 "f 1 2 3\nf 2 1 3\n")
                                            .view(),
                                        2)
                                  .positions);
    EXPECT_EQ(mesh.triangles.at(0).normal[0], Mesh::kNoNormal);
}

TEST(DisplacementTest, UndisplacedTrianglesKeepTheirNormals) {
    // Two squares side by side; the second has tilted normals and is not displaced.
    const std::string text = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 2 0 0\nv 2 0 1\nvn 0.6 0.8 0\n"
                             "usemtl a\nf 1//1 4//1 3//1 2//1\nusemtl b\nf 2//1 3//1 6//1 5//1\n";
    const Mesh mesh = displaced(text, {by(1.0, 0.0, 2)}, image(1, 1, {1.0f}));
    size_t kept = 0;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3& normal = mesh.normals.at(triangle.normal[k]);
            const double x = corner(mesh, triangle, k).x;
            if (triangle.material == 1 && x > 1.0) {
                EXPECT_NEAR(normal.x, 0.6, kRounding);
                EXPECT_EQ(corner(mesh, triangle, k).y, 0.0);
                ++kept;
            } else if (x == 1.0) {
                // Half of the height, on a surface that falls from 1 to 0 around.
                EXPECT_EQ(corner(mesh, triangle, k).y, 0.5);
                EXPECT_GT(normal.x, 0.7);
            }
        }
    }
    EXPECT_GT(kept, 50u);
}

TEST(DisplacementTest, RefusesTooManyTrianglesBeforeItMakesThem) {
    const TestMesh cube(kSplitCube);
    const PerMaterial tooMany = {by(1.0, 0.0, 11)};
    const SceneError error =
        errorOf([&] { displace(cube.view(), tooMany, std::vector{randomImage()}, "m.obj"); });
    EXPECT_EQ(error.where(), "scene.json: /subdivide");
    EXPECT_STREQ(error.what(),
                 "scene.json: /subdivide: the 12 triangles of \"m.obj\" would become 50331648, "
                 "above the limit of 16777216; lower \"subdivide\" to 10 or split the mesh");
}

TEST(DisplacementTest, MakesMillionsOfTrianglesInASecondOrTwo) {
    // 100 by 50 squares: 10,000 triangles.
    std::string text = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    for (int i = 0; i <= 50; ++i)
        for (int j = 0; j <= 100; ++j)
            text += "v " + std::to_string(j) + " 0 " + std::to_string(i) + "\n";
    for (int i = 0; i < 50; ++i) {
        for (int j = 1; j <= 100; ++j) {
            const int a = i * 101 + j;
            text += "f " + std::to_string(a) + "/1 " + std::to_string(a + 101) + "/2 " +
                    std::to_string(a + 102) + "/3 " + std::to_string(a + 1) + "/4\n";
        }
    }
    const TestMesh mesh(text);
    size_t triangles = 0;
    const double seconds = processorSeconds([&] {
        triangles =
            displace(mesh.view(), PerMaterial{by(1.0, 0.0, 4)}, std::vector{randomImage()}, "m.obj")
                ->triangles.size();
    });
    EXPECT_EQ(triangles, 2'560'000u);
    RecordProperty("seconds", std::to_string(seconds));
    EXPECT_LT(seconds, 10.0); // 1 or so; sanitizers and busy machines take longer
}

} // namespace
} // namespace calotype::test
