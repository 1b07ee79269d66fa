#include "mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/parallel_chunks.h"
#include "mesh/area_normals.h"
#include "mesh/smooth_normals.h"

namespace calotype {
namespace {

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The direction of the front's normal, of any length; exactly zero if the triangle has no area.
/// Edges are scaled first, so that they do not overflow or underflow.
glm::dvec3 scaledNormal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double size = std::max(largestComponent(ab), largestComponent(ac));
    return size == 0.0 ? glm::dvec3(0.0) : glm::cross(ab / size, ac / size);
}

/// Collects the values of `source` that triangles use, numbered in the order of first use.
template <typename Value>
class Compaction {
public:
    explicit Compaction(std::span<const Value> source)
        : source_(source), newIndex_(source.size(), kUnused) {
        values_.reserve(source.size());
    }

    /// The new index of `old`; `convert` makes the new value at the first use.
    template <typename Convert>
    uint32_t add(uint32_t old, Convert&& convert) {
        if (newIndex_[old] == kUnused) {
            newIndex_[old] = static_cast<uint32_t>(values_.size());
            values_.push_back(convert(source_[old]));
        }
        return newIndex_[old];
    }

    std::vector<Value> take() && { return std::move(values_); }

private:
    static constexpr uint32_t kUnused = ~0u;
    std::span<const Value> source_;
    std::vector<uint32_t> newIndex_;
    std::vector<Value> values_;
};

std::vector<glm::dvec3> inWorld(std::span<const glm::dvec3> positions,
                                const AffineTransform& worldFromObject) {
    std::vector<glm::dvec3> result(positions.size());
    parallelChunks(positions.size(), allCores(), [&](uint64_t first, uint64_t last) {
        for (uint64_t i = first; i < last; ++i)
            result[i] = worldFromObject.point(positions[i]);
    });
    return result;
}

/// Transforms triangles from object space to world space.
class MeshBuilder {
public:
    MeshBuilder(const ObjectMesh& source, const AffineTransform& worldFromObject, bool keepNormals)
        : source_(source), world_(inWorld(source.positions, worldFromObject)),
          worldNormal_(normalMatrix(worldFromObject.linear)),
          mirrored_(isMirroring(worldFromObject.linear)), keepNormals_(keepNormals),
          extents_(source.triangles.size()), positions_(world_), normals_(source.normals),
          uvs_(source.uvs) {
        parallelChunks(extents_.size(), allCores(), [&](uint64_t first, uint64_t last) {
            for (uint64_t i = first; i < last; ++i)
                extents_[i] = extentOf(source.triangles[i]);
        });
        triangles_.reserve(source.triangles.size());
    }

    /// Adds the triangle `index`. Throws SceneError at `where` if a vertex is no longer finite.
    void add(size_t index, const std::string& where) {
        if (extents_[index] == Extent::Infinite)
            throw SceneError(where, "a vertex lies beyond the range of finite numbers");
        if (extents_[index] == Extent::NoArea) {
            ++dropped_;
            return;
        }
        Mesh::Triangle triangle = source_.triangles[index];
        if (mirrored_) {
            std::swap(triangle.position[1], triangle.position[2]);
            std::swap(triangle.normal[1], triangle.normal[2]);
            std::swap(triangle.uv[1], triangle.uv[2]);
        }
        const bool hasNormals = keepNormals_ && triangle.normal[0] != Mesh::kNoNormal;
        const bool hasUvs = triangle.uv[0] != Mesh::kNoUv;
        for (int k = 0; k < 3; ++k) {
            uint32_t& position = triangle.position[k];
            uint32_t& normal = triangle.normal[k];
            uint32_t& uv = triangle.uv[k];
            position = positions_.add(position, [](const auto& moved) { return moved; });
            normal = hasNormals ? normals_.add(normal, [&](const auto& n) { return turned(n); })
                                : Mesh::kNoNormal;
            uv = hasUvs ? uvs_.add(uv, [](const auto& given) { return given; }) : Mesh::kNoUv;
        }
        triangles_.push_back(triangle);
    }

    MeshAndDropped take() && {
        return {{std::move(positions_).take(), std::move(normals_).take(), std::move(uvs_).take(),
                 std::move(triangles_)},
                dropped_};
    }

private:
    enum class Extent : uint8_t { Area, NoArea, Infinite };

    /// In the order of the corners after a mirroring, on which rounding depends.
    Extent extentOf(const Mesh::Triangle& triangle) const {
        const glm::dvec3& a = world_[triangle.position[0]];
        const glm::dvec3& b = world_[triangle.position[mirrored_ ? 2 : 1]];
        const glm::dvec3& c = world_[triangle.position[mirrored_ ? 1 : 2]];
        if (!isFinite(a) || !isFinite(b) || !isFinite(c))
            return Extent::Infinite;
        return scaledNormal(a, b, c) == glm::dvec3(0.0) ? Extent::NoArea : Extent::Area;
    }

    glm::dvec3 turned(const glm::dvec3& normal) const {
        return glm::normalize(worldNormal_ * (normal / largestComponent(normal)));
    }

    const ObjectMesh& source_;
    std::vector<glm::dvec3> world_; ///< the positions
    glm::dmat3 worldNormal_;
    bool mirrored_;
    bool keepNormals_;
    std::vector<Extent> extents_; ///< of the triangles
    Compaction<glm::dvec3> positions_;
    Compaction<glm::dvec3> normals_;
    Compaction<glm::dvec2> uvs_;
    std::vector<Mesh::Triangle> triangles_;
    uint64_t dropped_ = 0;
};

} // namespace

MeshAndDropped buildMesh(const ObjectMesh& source, const AffineTransform& worldFromObject,
                         NormalMode mode, const std::string& where, const OnProgress& onProgress) {
    MeshBuilder builder(source, worldFromObject, mode == NormalMode::Auto);
    for (size_t i = 0; i < source.triangles.size(); ++i) {
        reportStep(onProgress, i, source.triangles.size());
        builder.add(i, where);
    }
    MeshAndDropped result = std::move(builder).take();
    if (result.mesh.triangles.empty())
        throw SceneError(where, "no triangle of this shape has an area");
    if (mode == NormalMode::Smooth)
        smoothNormals(result.mesh.positions, result.mesh.triangles, result.mesh.normals);
    return result;
}

double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

} // namespace calotype
