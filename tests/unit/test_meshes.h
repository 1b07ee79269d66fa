#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/object_mesh.h"
#include "read/obj/obj_file.h"

namespace calotype::test {

/// Of lengths and areas near one, after some ten operations.
constexpr double kRounding = 1e-14;

/// A cube from -1 to 1, each side with texture coordinates of its own and its corners written
/// anew: seams and split vertices along every edge.
inline const std::string kSplitCube = [] {
    const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::string text;
    for (int side = 0; side < 6; ++side) {
        for (const int corner : sides[side]) {
            text += "v " + std::to_string(corner & 1 ? 1 : -1) + " " +
                    std::to_string(corner & 2 ? 1 : -1) + " " +
                    std::to_string(corner & 4 ? 1 : -1) + "\n";
        }
        const std::string u = std::to_string(side * 0.1);
        text += "vt " + u + " 0\nvt 1 " + u + "\nvt 0.9 1\nvt " + u + " 0.8\n" +
                "f -4/-4 -3/-3 -2/-2 -1/-1\n";
    }
    return text;
}();

/// The file's mesh, all of material 0 unless it names others: its materials count from 0.
class TestMesh {
public:
    explicit TestMesh(const std::string& text) : obj_(parseObj(text, "m.obj")) {
        for (Mesh::Triangle& triangle : obj_.triangles)
            triangle.material = triangle.material == ObjFile::kNoMaterial ? 0 : triangle.material;
    }

    ObjectMesh view() const { return {obj_.positions, obj_.normals, obj_.uvs, obj_.triangles}; }

private:
    ObjFile obj_;
};

inline glm::dvec3 corner(const Mesh& mesh, const Mesh::Triangle& triangle, int k) {
    return mesh.positions.at(triangle.position[k]);
}

inline glm::dvec3 areaVector(const Mesh& mesh, const Mesh::Triangle& t) {
    const glm::dvec3 a = corner(mesh, t, 0);
    return 0.5 * glm::cross(corner(mesh, t, 1) - a, corner(mesh, t, 2) - a);
}

inline double areaOf(const Mesh& mesh) {
    double sum = 0.0;
    for (const Mesh::Triangle& triangle : mesh.triangles)
        sum += glm::length(areaVector(mesh, triangle));
    return sum;
}

/// By the divergence theorem.
inline double volumeOf(const Mesh& mesh) {
    double sum = 0.0;
    for (const Mesh::Triangle& triangle : mesh.triangles)
        sum += glm::dot(areaVector(mesh, triangle), corner(mesh, triangle, 0)) / 3.0;
    return sum;
}

struct LessByValue {
    bool operator()(const glm::dvec3& a, const glm::dvec3& b) const {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    }
};

/// What summing over so many triangles may lose of `total`: a rounding each.
inline double sumRounding(const Mesh& mesh, double total) {
    return 1.2e-16 * static_cast<double>(mesh.triangles.size()) * total;
}

/// Whether every edge, by the values of its ends, is run along once each way.
inline void expectWatertight(const Mesh& mesh) {
    std::map<glm::dvec3, int, LessByValue> number;
    std::map<std::pair<int, int>, int> runs;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        int ends[3];
        for (int k = 0; k < 3; ++k)
            ends[k] = number.try_emplace(corner(mesh, triangle, k), number.size()).first->second;
        for (int k = 0; k < 3; ++k)
            ++runs[{ends[k], ends[(k + 1) % 3]}];
    }
    for (const auto& [edge, count] : runs) {
        ASSERT_EQ(count, 1);
        ASSERT_EQ(runs.count({edge.second, edge.first}), 1u) << "an edge has one side only";
    }
}

} // namespace calotype::test
