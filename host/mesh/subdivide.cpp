#include "mesh/subdivide.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/area_normals.h"
#include "mesh/distinct_values.h"

namespace calotype {
namespace {

/// Zero if the two are opposite; no corner may keep a zero normal.
glm::dvec3 middleNormal(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 sum = a + b;
    return sum == glm::dvec3(0.0) ? sum : glm::normalize(sum);
}

glm::dvec3 unitNormal(const glm::dvec3& normal) {
    const double size = largestComponent(normal);
    return size > 0.0 ? glm::normalize(normal / size) : normal;
}

class Subdivider {
public:
    explicit Subdivider(const ObjectMesh& mesh)
        : triangles_(mesh.triangles.begin(), mesh.triangles.end()) {
        const std::vector<uint32_t> position = positions_.addAll(mesh.positions);
        const std::vector<uint32_t> uv = uvs_.addAll(mesh.uvs);
        std::vector<uint32_t> normal;
        normal.reserve(mesh.normals.size());
        for (const glm::dvec3& given : mesh.normals)
            normal.push_back(normals_.add(unitNormal(given)));
        for (Mesh::Triangle& triangle : triangles_) {
            for (int k = 0; k < 3; ++k) {
                triangle.position[k] = position[triangle.position[k]];
                if (triangle.normal[k] != Mesh::kNoNormal)
                    triangle.normal[k] = normal[triangle.normal[k]];
                if (triangle.uv[k] != Mesh::kNoUv)
                    triangle.uv[k] = uv[triangle.uv[k]];
            }
        }
    }

    void step() {
        std::vector<Mesh::Triangle> finer;
        finer.reserve(4 * triangles_.size());
        for (const Mesh::Triangle& triangle : triangles_)
            split(triangle, finer);
        triangles_ = std::move(finer);
    }

    Mesh take() && {
        return {std::move(positions_).take(), std::move(normals_).take(), std::move(uvs_).take(),
                std::move(triangles_)};
    }

private:
    /// The corners of the four triangles: one at each corner and one in the middle.
    static constexpr int kCorners[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {4, 5, 3}};

    /// The three corners and, as 3 to 5, the middles of the edges 01, 12 and 20.
    template <typename Middle>
    static void refine(const uint32_t (&corners)[3], Middle&& middle, uint32_t (&six)[6]) {
        for (int k = 0; k < 3; ++k) {
            six[k] = corners[k];
            six[3 + k] = middle(corners[k], corners[(k + 1) % 3]);
        }
    }

    void split(const Mesh::Triangle& triangle, std::vector<Mesh::Triangle>& finer) {
        const bool hasNormals = triangle.normal[0] != Mesh::kNoNormal;
        const bool hasUvs = triangle.uv[0] != Mesh::kNoUv;
        uint32_t position[6];
        uint32_t normal[6];
        uint32_t uv[6];
        refine(
            triangle.position,
            [&](uint32_t a, uint32_t b) {
                // Halved first to avoid overflow; equal from both sides of an edge.
                return positions_.add(0.5 * positions_[a] + 0.5 * positions_[b]);
            },
            position);
        if (hasNormals) {
            refine(
                triangle.normal,
                [&](uint32_t a, uint32_t b) {
                    return normals_.add(middleNormal(normals_[a], normals_[b]));
                },
                normal);
        }
        if (hasUvs) {
            refine(
                triangle.uv,
                [&](uint32_t a, uint32_t b) { return uvs_.add(0.5 * uvs_[a] + 0.5 * uvs_[b]); },
                uv);
        }
        for (const auto& corners : kCorners) {
            Mesh::Triangle child = triangle;
            for (int k = 0; k < 3; ++k) {
                child.position[k] = position[corners[k]];
                child.normal[k] = hasNormals ? normal[corners[k]] : Mesh::kNoNormal;
                child.uv[k] = hasUvs ? uv[corners[k]] : Mesh::kNoUv;
            }
            if (hasNormals && std::ranges::any_of(child.normal, [&](uint32_t n) {
                    return normals_[n] == glm::dvec3(0.0);
                })) {
                std::ranges::fill(child.normal, Mesh::kNoNormal);
            }
            finer.push_back(child);
        }
    }

    std::vector<Mesh::Triangle> triangles_;
    DistinctValues<glm::dvec3> positions_;
    DistinctValues<glm::dvec3> normals_;
    DistinctValues<glm::dvec2> uvs_;
};

} // namespace

uint64_t subdividedCount(uint64_t count, uint32_t times) {
    constexpr uint64_t kMost = std::numeric_limits<uint64_t>::max();
    for (uint32_t i = 0; i < times && count > 0; ++i) {
        if (count > kMost / 4)
            return kMost;
        count *= 4;
    }
    return count;
}

Mesh subdivide(const ObjectMesh& mesh, uint32_t times) {
    Subdivider subdivider(mesh);
    for (uint32_t i = 0; i < times; ++i)
        subdivider.step();
    return std::move(subdivider).take();
}

} // namespace calotype
