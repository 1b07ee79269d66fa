#include "scene/mesh_builder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"

namespace calotype {
namespace {

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double largestComponent(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The direction of the front's normal, scaled at will; zero exactly where the triangle has no
/// area. Edges are scaled first, lest tiny triangles underflow and huge ones overflow.
glm::dvec3 scaledNormal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double size = std::max(largestComponent(ab), largestComponent(ac));
    return size == 0.0 ? glm::dvec3(0.0) : glm::cross(ab / size, ac / size);
}

/// Numbers the entries in use in the order of their first use.
class Compaction {
public:
    explicit Compaction(size_t count) : newIndex_(count, kUnused) {}

    /// The new index of `old`; `isNew` tells whether it is met for the first time.
    std::pair<uint32_t, bool> add(uint32_t old) {
        const bool isNew = newIndex_[old] == kUnused;
        if (isNew) {
            newIndex_[old] = count_++;
        }
        return {newIndex_[old], isNew};
    }

private:
    static constexpr uint32_t kUnused = ~0u;
    std::vector<uint32_t> newIndex_;
    uint32_t count_ = 0;
};

struct PositionHash {
    size_t operator()(const glm::dvec3& p) const {
        size_t hash = 0;
        for (int i = 0; i < 3; ++i) {
            // Adding zero makes -0 and 0, which are equal, the same bits.
            const auto bits = std::bit_cast<uint64_t>(p[i] + 0.0);
            hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

/// Replaces the normals by one per distinct position. Triangles at a position whose normals
/// cancel become flat.
void smoothNormals(Mesh& mesh) {
    std::unordered_map<glm::dvec3, uint32_t, PositionHash> normalAt;
    mesh.normals.clear();
    for (Mesh::Triangle& triangle : mesh.triangles) {
        const glm::dvec3& a = mesh.positions[triangle.position[0]];
        const glm::dvec3& b = mesh.positions[triangle.position[1]];
        const glm::dvec3& c = mesh.positions[triangle.position[2]];
        for (int k = 0; k < 3; ++k) {
            const auto next = static_cast<uint32_t>(mesh.normals.size());
            const auto [entry, isNew] =
                normalAt.try_emplace(mesh.positions[triangle.position[k]], next);
            if (isNew) {
                mesh.normals.emplace_back(0.0);
            }
            triangle.normal[k] = entry->second;
            mesh.normals[entry->second] += glm::cross(b - a, c - a);
        }
    }
    for (glm::dvec3& normal : mesh.normals) {
        const double size = largestComponent(normal);
        normal =
            size > 0.0 && std::isfinite(size) ? glm::normalize(normal / size) : glm::dvec3(0.0);
    }
    for (Mesh::Triangle& triangle : mesh.triangles) {
        const bool cancelled =
            std::any_of(std::begin(triangle.normal), std::end(triangle.normal),
                        [&](uint32_t index) { return mesh.normals[index] == glm::dvec3(0.0); });
        if (cancelled) {
            std::fill(std::begin(triangle.normal), std::end(triangle.normal), Mesh::kNoNormal);
        }
    }
}

} // namespace

MeshAndDropped buildMesh(std::span<const glm::dvec3> positions, std::span<const glm::dvec3> normals,
                         std::span<const Mesh::Triangle> triangles,
                         const AffineTransform& worldFromObject, NormalMode mode,
                         const std::string& where) {
    const bool mirrored = isMirroring(worldFromObject.linear);
    const glm::dmat3 worldNormal = normalMatrix(worldFromObject.linear);
    MeshAndDropped result;
    Mesh& mesh = result.mesh;
    mesh.triangles.reserve(triangles.size());
    mesh.positions.reserve(positions.size());
    Compaction usedPositions(positions.size());
    Compaction usedNormals(normals.size());

    for (Mesh::Triangle triangle : triangles) {
        if (mirrored) {
            std::swap(triangle.position[1], triangle.position[2]);
            std::swap(triangle.normal[1], triangle.normal[2]);
        }
        glm::dvec3 corner[3];
        for (int k = 0; k < 3; ++k) {
            corner[k] = worldFromObject.point(positions[triangle.position[k]]);
            if (!isFinite(corner[k])) {
                throw SceneError(where, "a vertex lies beyond the range of finite numbers");
            }
        }
        if (scaledNormal(corner[0], corner[1], corner[2]) == glm::dvec3(0.0)) {
            ++result.dropped;
            continue;
        }
        const bool keepNormals = mode == NormalMode::Auto && triangle.normal[0] != Mesh::kNoNormal;
        for (int k = 0; k < 3; ++k) {
            const auto [position, newPosition] = usedPositions.add(triangle.position[k]);
            if (newPosition) {
                mesh.positions.push_back(corner[k]);
            }
            triangle.position[k] = position;
            if (!keepNormals) {
                triangle.normal[k] = Mesh::kNoNormal;
                continue;
            }
            const glm::dvec3& given = normals[triangle.normal[k]];
            const auto [normal, newNormal] = usedNormals.add(triangle.normal[k]);
            if (newNormal) {
                mesh.normals.push_back(
                    glm::normalize(worldNormal * (given / largestComponent(given))));
            }
            triangle.normal[k] = normal;
        }
        mesh.triangles.push_back(triangle);
    }
    if (mesh.triangles.empty()) {
        throw SceneError(where, "no triangle of this shape has an area");
    }
    if (mode == NormalMode::Smooth) {
        smoothNormals(mesh);
    }
    return result;
}

double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

} // namespace calotype
