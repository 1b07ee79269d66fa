#include "mesh/subdivide.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "base/fork_join.h"
#include "base/parallel_for.h"
#include "mesh/area_normals.h"
#include "mesh/distinct_values.h"

namespace calotype {
namespace {

/// Halved first to avoid overflow; equal from both ends.
template <typename Vector>
Vector middlePoint(const Vector& a, const Vector& b) {
    return 0.5 * a + 0.5 * b;
}

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
        // Nearly all of the time is taken by numbering the middles: the positions' on a thread of
        // their own.
        const bool forks = triangles_.size() >= kWorthAThread && allCores() > 1;
        std::vector<Middles> position;
        std::vector<Middles> normal;
        std::vector<Middles> uv;
        forkJoin(
            forks,
            [&] {
                position =
                    middlesOf(positions_, &Mesh::Triangle::position, middlePoint<glm::dvec3>);
            },
            [&] {
                normal = middlesOf(normals_, &Mesh::Triangle::normal, middleNormal);
                uv = middlesOf(uvs_, &Mesh::Triangle::uv, middlePoint<glm::dvec2>);
            });
        std::vector<Mesh::Triangle> finer;
        finer.reserve(4 * triangles_.size());
        for (size_t i = 0; i < triangles_.size(); ++i)
            split(triangles_[i], {position[i], normal[i], uv[i]}, finer);
        triangles_ = std::move(finer);
    }

    Mesh take() && {
        return {std::move(positions_).take(), std::move(normals_).take(), std::move(uvs_).take(),
                std::move(triangles_)};
    }

private:
    static constexpr size_t kWorthAThread = 8192; ///< triangles: a millisecond of work
    static constexpr uint32_t kNone = Mesh::kNoUv;
    static_assert(Mesh::kNoNormal == kNone);

    /// The numbers of the middles of a triangle's edges 01, 12 and 20; or kNone.
    using Middles = std::array<uint32_t, 3>;

    struct MiddlesOfTriangle {
        const Middles& position;
        const Middles& normal;
        const Middles& uv;
    };

    /// For each triangle. `corners` are numbers in `values`, to which the middles are added.
    template <typename Vector>
    std::vector<Middles> middlesOf(DistinctValues<Vector>& values,
                                   uint32_t (Mesh::Triangle::*corners)[3],
                                   Vector (*middle)(const Vector&, const Vector&)) const {
        std::vector<Middles> result(triangles_.size(), {kNone, kNone, kNone});
        if (!values.values().empty()) // two triangles have about three edges
            values.reserve(values.values().size() + 2 * triangles_.size());
        for (size_t i = 0; i < triangles_.size(); ++i) {
            const auto& corner = triangles_[i].*corners;
            for (int k = 0; k < 3 && corner[0] != kNone; ++k)
                result[i][k] = values.add(middle(values[corner[k]], values[corner[(k + 1) % 3]]));
        }
        return result;
    }

    void split(const Mesh::Triangle& triangle, const MiddlesOfTriangle& middles,
               std::vector<Mesh::Triangle>& finer) const {
        // At each corner one triangle, and one in the middle.
        const auto add = [&](int first, int second, int third) {
            Mesh::Triangle child = triangle;
            const int six[3] = {first, second, third};
            for (int k = 0; k < 3; ++k) {
                const auto choose = [&](const uint32_t(&corners)[3], const Middles& middle) {
                    return six[k] < 3 ? corners[six[k]] : middle[six[k] - 3];
                };
                child.position[k] = choose(triangle.position, middles.position);
                child.normal[k] = choose(triangle.normal, middles.normal);
                child.uv[k] = choose(triangle.uv, middles.uv);
            }
            if (child.normal[0] != kNone && std::ranges::any_of(child.normal, [&](uint32_t n) {
                    return normals_[n] == glm::dvec3(0.0);
                })) {
                std::ranges::fill(child.normal, kNone);
            }
            finer.push_back(child);
        };
        add(0, 3, 5);
        add(3, 1, 4);
        add(5, 4, 2);
        add(4, 5, 3);
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
