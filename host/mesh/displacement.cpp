#include "mesh/displacement.h"

#include <algorithm>
#include <compare>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "base/names.h"
#include "base/parallel_chunks.h"
#include "mesh/area_normals.h"
#include "mesh/subdivide.h"
#include "scene/texture_lookup.h"

namespace calotype {
namespace {

using OfMaterial = std::span<const std::optional<Displacement>>;

constexpr uint32_t kNone = ~0u;

const Displacement* displacementOf(const Mesh::Triangle& triangle, OfMaterial ofMaterial) {
    if (triangle.material >= ofMaterial.size() || !ofMaterial[triangle.material])
        return nullptr;
    return &*ofMaterial[triangle.material];
}

/// The displacement with the most subdivisions; nullptr if there is none.
const Displacement* finest(std::span<const Mesh::Triangle> triangles, OfMaterial ofMaterial) {
    const Displacement* result = nullptr;
    for (const Mesh::Triangle& triangle : triangles) {
        const Displacement* displacement = displacementOf(triangle, ofMaterial);
        if (displacement && (!result || displacement->subdivide > result->subdivide))
            result = displacement;
    }
    return result;
}

void checkCount(uint64_t count, const Displacement& displacement, const std::string& name) {
    const uint64_t foreseen = subdividedCount(count, displacement.subdivide);
    if (displacement.subdivide == 0 || foreseen <= kMostDisplacedTriangles)
        return;
    uint32_t possible = 0;
    while (subdividedCount(count, possible + 1) <= kMostDisplacedTriangles)
        ++possible;
    throw SceneError(displacement.place,
                     "the " + std::to_string(count) + " triangles of " + inQuotes(name) +
                         " would become " + std::to_string(foreseen) + ", above the limit of " +
                         std::to_string(kMostDisplacedTriangles) + "; lower \"subdivide\" to " +
                         std::to_string(possible) + " or split the mesh");
}

/// For each material, the first material with a displacement to the same heights; kNone for none.
std::vector<uint32_t> heightSources(OfMaterial ofMaterial) {
    std::vector<uint32_t> sources(ofMaterial.size(), kNone);
    const auto key = [&](uint32_t material) {
        const Displacement& displacement = *ofMaterial[material];
        return std::tuple(displacement.texture, displacement.scale, displacement.mid);
    };
    for (uint32_t i = 0; i < sources.size(); ++i)
        for (uint32_t k = 0; ofMaterial[i] && sources[i] == kNone; ++k)
            sources[i] = ofMaterial[k] && key(k) == key(i) ? k : kNone;
    return sources;
}

/// The inputs of a position's height.
struct Reading {
    uint32_t position = kNone;
    uint32_t source = kNone; ///< a material; kNone if the triangle is not displaced
    uint32_t uv = kNone;     ///< Mesh::kNoUv if there are none

    auto operator<=>(const Reading&) const = default;
};

class Displacer {
public:
    Displacer(Mesh mesh, OfMaterial ofMaterial, std::span<const Texture> textures)
        : mesh_(std::move(mesh)), ofMaterial_(ofMaterial), sources_(heightSources(ofMaterial)),
          textures_(textures) {}

    Mesh run(SurfaceNormals normals) && {
        move();
        if (normals == SurfaceNormals::Made)
            followSurface();
        return std::move(mesh_);
    }

private:
    bool isMoved(const Mesh::Triangle& triangle) const {
        return displacementOf(triangle, ofMaterial_) != nullptr;
    }

    Reading readingOf(const Mesh::Triangle& triangle, int corner) const {
        if (!isMoved(triangle))
            return {triangle.position[corner], kNone, kNone};
        return {triangle.position[corner], sources_[triangle.material], triangle.uv[corner]};
    }

    double height(const Reading& reading) const {
        if (reading.source == kNone)
            return 0.0;
        const Displacement& displacement = *ofMaterial_[reading.source];
        const glm::dvec2 uv = reading.uv == Mesh::kNoUv ? glm::dvec2(0.0) : mesh_.uvs[reading.uv];
        const double value = lookUpScalar(textures_[displacement.texture], uv);
        return displacement.scale * (value - displacement.mid);
    }

    /// One height for each position. Nearly all have one reading only; the others are sorted.
    std::vector<double> meanHeights() const {
        std::vector<Reading> first(mesh_.positions.size());
        std::vector<Reading> further;
        for (const Mesh::Triangle& triangle : mesh_.triangles) {
            for (int k = 0; k < 3; ++k) {
                const Reading reading = readingOf(triangle, k);
                Reading& known = first[reading.position];
                if (known.position == kNone)
                    known = reading;
                else if (known != reading)
                    further.push_back(reading);
            }
        }
        std::ranges::sort(further);
        const auto repeated = std::ranges::unique(further);
        further.erase(repeated.begin(), repeated.end());

        std::vector<double> heights(first.size());
        parallelChunks(first.size(), allCores(), [&](uint64_t begin, uint64_t end) {
            for (uint64_t i = begin; i < end; ++i)
                heights[i] = height(first[i]);
        });
        for (auto next = further.begin(); next != further.end();) {
            const uint32_t position = next->position;
            uint32_t count = 1;
            for (; next != further.end() && next->position == position; ++next) {
                heights[position] += height(*next);
                ++count;
            }
            heights[position] /= count;
        }
        return heights;
    }

    void move() {
        const std::vector<double> heights = meanHeights();
        const std::vector<glm::dvec3> directions =
            areaWeightedNormals(mesh_.positions, mesh_.triangles);
        for (size_t i = 0; i < mesh_.positions.size(); ++i)
            mesh_.positions[i] += heights[i] * directions[i];
    }

    /// Appends the normals of the displaced surface.
    void followSurface() {
        std::vector<bool> touched(mesh_.positions.size());
        for (const Mesh::Triangle& triangle : mesh_.triangles) {
            if (isMoved(triangle))
                for (const uint32_t corner : triangle.position)
                    touched[corner] = true;
        }
        const auto firstNew = static_cast<uint32_t>(mesh_.normals.size());
        const std::vector<glm::dvec3> surface =
            areaWeightedNormals(mesh_.positions, mesh_.triangles);
        mesh_.normals.insert(mesh_.normals.end(), surface.begin(), surface.end());
        for (Mesh::Triangle& triangle : mesh_.triangles) {
            if (!isMoved(triangle) && triangle.normal[0] == Mesh::kNoNormal)
                continue;
            for (int k = 0; k < 3; ++k)
                if (touched[triangle.position[k]])
                    triangle.normal[k] = firstNew + triangle.position[k];
            if (std::ranges::any_of(triangle.normal, [&](uint32_t normal) {
                    return mesh_.normals[normal] == glm::dvec3(0.0);
                })) {
                std::ranges::fill(triangle.normal, Mesh::kNoNormal);
            }
        }
    }

    Mesh mesh_;
    OfMaterial ofMaterial_;
    std::vector<uint32_t> sources_;
    std::span<const Texture> textures_;
};

/// The triangles, without references to normals of displaced triangles, which are not used.
std::vector<Mesh::Triangle> withoutVainNormals(std::span<const Mesh::Triangle> triangles,
                                               OfMaterial ofMaterial) {
    std::vector<Mesh::Triangle> result(triangles.begin(), triangles.end());
    for (Mesh::Triangle& triangle : result)
        if (displacementOf(triangle, ofMaterial))
            std::ranges::fill(triangle.normal, Mesh::kNoNormal);
    return result;
}

} // namespace

std::optional<Mesh> displace(const ObjectMesh& mesh,
                             std::span<const std::optional<Displacement>> ofMaterial,
                             std::span<const Texture> textures, const std::string& name,
                             SurfaceNormals normals) {
    const Displacement* most = finest(mesh.triangles, ofMaterial);
    if (!most)
        return std::nullopt;
    checkCount(mesh.triangles.size(), *most, name);
    const auto triangles = withoutVainNormals(mesh.triangles, ofMaterial);
    const ObjectMesh source{mesh.positions, mesh.normals, mesh.uvs, triangles};
    return Displacer(subdivide(source, most->subdivide), ofMaterial, textures).run(normals);
}

} // namespace calotype
