// Subdivision: counts, midpoints, and positions that neighbours share.

#include <cmath>
#include <set>

#include "mesh/subdivide.h"
#include "test_meshes.h"

namespace calotype::test {
namespace {

TEST(SubdivideTest, CountsAreForeseen) {
    EXPECT_EQ(subdividedCount(5, 0), 5u);
    EXPECT_EQ(subdividedCount(5, 3), 320u);
    EXPECT_EQ(subdividedCount(1, 31), uint64_t{1} << 62);
    EXPECT_EQ(subdividedCount(1, 32), ~uint64_t{0});
    EXPECT_EQ(subdividedCount(7, ~0u), ~uint64_t{0});
    EXPECT_EQ(subdividedCount(0, ~0u), 0u);
}

TEST(SubdivideTest, SplitsAtTheMidpointsOfEdges) {
    const TestMesh one("v 0 0 0\nv 4 0 0\nv 0 4 2\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 0 9 0\n"
                       "vn 0 0 1\nf 1/1/1 2/2/2 3/3/3\n");
    const Mesh mesh = subdivide(one.view(), 1);
    ASSERT_EQ(mesh.triangles.size(), 4u);
    EXPECT_EQ(mesh.positions.size(), 6u);
    const std::set<glm::dvec3, LessByValue> positions(mesh.positions.begin(), mesh.positions.end());
    for (const glm::dvec3 middle : {glm::dvec3(2, 0, 0), {2, 2, 1}, {0, 2, 1}})
        EXPECT_TRUE(positions.contains(middle)) << middle.x << " " << middle.y << " " << middle.z;
    const glm::dvec3 whole = glm::cross(glm::dvec3(4, 0, 0), glm::dvec3(0, 4, 2));
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        // A quarter of the triangle, on its side.
        EXPECT_EQ(areaVector(mesh, triangle), whole / 8.0);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p = corner(mesh, triangle, k);
            EXPECT_EQ(mesh.uvs.at(triangle.uv[k]), glm::dvec2(p.x / 4.0, p.y / 4.0));
            // From (0, 1, 0) where x is 4 to (0, 0, 1) where it is 0, by the middle of both.
            const double tilt = p.x == 2.0 ? std::sqrt(0.5) : p.x / 4.0;
            EXPECT_NEAR(mesh.normals.at(triangle.normal[k]).y, tilt, kRounding);
        }
    }
}

TEST(SubdivideTest, MakesFourOfEachAndSharesAllPositions) {
    const TestMesh cube(kSplitCube);
    for (const uint32_t times : {0u, 1u, 3u, 5u}) {
        const Mesh mesh = subdivide(cube.view(), times);
        const size_t triangles = 12u << (2 * times);
        EXPECT_EQ(mesh.triangles.size(), triangles);
        // Euler: V - E + F = 2 with E = 3 F / 2, though the file has 24 positions.
        EXPECT_EQ(mesh.positions.size(), triangles / 2 + 2);
        expectWatertight(mesh);
        EXPECT_NEAR(volumeOf(mesh), 8.0, sumRounding(mesh, 8.0));
    }
}

TEST(SubdivideTest, OppositeNormalsLeaveTheirTrianglesFlat) {
    const TestMesh two("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 -1\nvn 0 1 1\n"
                       "usemtl a\nf 1//1 2//2 3//1\nusemtl b\nf 1//1 2//3 3//1\n");
    const Mesh mesh = subdivide(two.view(), 2);
    ASSERT_EQ(mesh.triangles.size(), 32u);
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (const uint32_t normal : triangle.normal)
            if (triangle.material == 0)
                EXPECT_EQ(normal, Mesh::kNoNormal);
            else
                EXPECT_NEAR(glm::length(mesh.normals.at(normal)), 1.0, kRounding);
    }
}

} // namespace
} // namespace calotype::test
