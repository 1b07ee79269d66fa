#pragma once

#include <array>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "scene/scene.h"

namespace calotype::test {

/// An octahedron whose triangles were split `levels` times, its corners and their normals on the
/// unit sphere.
inline Mesh coarseBall(int levels) {
    Mesh mesh;
    using Corners = std::array<glm::dvec3, 3>;
    std::vector<Corners> triangles;
    for (const double x : {1.0, -1.0})
        for (const double y : {1.0, -1.0})
            for (const double z : {1.0, -1.0}) {
                Corners corners = {glm::dvec3(x, 0, 0), glm::dvec3(0, y, 0), glm::dvec3(0, 0, z)};
                if (x * y * z < 0.0)
                    std::swap(corners[1], corners[2]);
                triangles.push_back(corners);
            }
    for (int level = 0; level < levels; ++level) {
        std::vector<Corners> finer;
        for (const auto& [a, b, c] : triangles) {
            const glm::dvec3 ab = glm::normalize(a + b);
            const glm::dvec3 bc = glm::normalize(b + c);
            const glm::dvec3 ca = glm::normalize(c + a);
            finer.insert(finer.end(), {Corners{a, ab, ca}, Corners{ab, b, bc}, Corners{ca, bc, c},
                                       Corners{ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    for (const Corners& corners : triangles) {
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
        mesh.normals.insert(mesh.normals.end(), corners.begin(), corners.end());
        mesh.triangles.push_back({{first, first + 1, first + 2}, {first, first + 1, first + 2}, 0});
    }
    return mesh;
}

} // namespace calotype::test
