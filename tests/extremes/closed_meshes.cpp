#include "extremes/closed_meshes.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "support/test_scenes.h"

namespace calotype::test {

Mesh withPositions(Mesh mesh, const std::function<glm::dvec3(const glm::dvec3&)>& place) {
    for (glm::dvec3& position : mesh.positions)
        position = place(position);
    return mesh;
}

Mesh turned(Mesh mesh) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(1.0, 2.0, 3.0));
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0.0, 1.0, 0.3)));
    const glm::dmat3 rotation(x, y, glm::cross(x, y));
    return withPositions(std::move(mesh), [&](const glm::dvec3& p) { return rotation * p; });
}

Mesh stretched(Mesh mesh, const glm::dvec3& factors) {
    return withPositions(std::move(mesh), [&](const glm::dvec3& p) { return factors * p; });
}

Mesh moved(Mesh mesh, const glm::dvec3& offset) {
    return withPositions(std::move(mesh), [&](const glm::dvec3& p) { return p + offset; });
}

Mesh displacedBall(uint32_t level) {
    return withPositions(icosphere(level, glm::dvec3(0.0), 1.0), [](const glm::dvec3& p) {
        const double wave =
            std::sin(7.0 * p.x + 1.0) * std::sin(11.0 * p.y) * std::sin(13.0 * p.z + 2.0);
        return (1.0 + 0.5 * wave) * p;
    });
}

Mesh boxWithCuts(const std::vector<double>& cuts) {
    constexpr uint32_t kNo = Mesh::kNoNormal;
    const auto n = static_cast<uint32_t>(cuts.size());
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto first = static_cast<uint32_t>(mesh.positions.size());
            for (uint32_t i = 0; i < n; ++i)
                for (uint32_t j = 0; j < n; ++j) {
                    glm::dvec3 p;
                    p[axis] = side;
                    p[(axis + 1) % 3] = cuts[side > 0.0 ? i : n - 1 - i]; // fronts face outward
                    p[(axis + 2) % 3] = cuts[j];
                    mesh.positions.push_back(p);
                }
            for (uint32_t i = 0; i + 1 < n; ++i)
                for (uint32_t j = 0; j + 1 < n; ++j) {
                    const uint32_t a = first + i * n + j;
                    mesh.triangles.push_back({{a, a + n, a + n + 1}, {kNo, kNo, kNo}, 0});
                    mesh.triangles.push_back({{a, a + n + 1, a + 1}, {kNo, kNo, kNo}, 0});
                }
        }
    }
    return mesh;
}

std::vector<double> sliverCuts(double width) {
    std::vector<double> cuts = {-1.0, -1.0 + width, 0.0};
    for (int i = 0; i <= 8; ++i)
        cuts.push_back(0.3 + width * i);
    cuts.insert(cuts.end(), {0.5, 1.0 - width, 1.0});
    return cuts;
}

} // namespace calotype::test
