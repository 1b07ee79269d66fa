#include "mesh/smooth_normals.h"

#include <algorithm>
#include <utility>

#include <glm/vec2.hpp>

#include "mesh/area_normals.h"
#include "mesh/distinct_values.h"

namespace calotype {
namespace {

using Triangles = std::span<Mesh::Triangle>;

/// The triangles' corners, numbered so that those which share a normal are equal, and the position
/// of each number.
struct SharedCorners {
    std::vector<Corners> triangles;
    std::vector<glm::dvec3> positions;
};

/// Each place, a number of `positions`, becomes one corner for each group there.
SharedCorners splitByGroup(SharedCorners shared, std::span<const Smoothing> smoothing) {
    DistinctValues<glm::dvec2> distinct; // place and group
    for (size_t i = 0; i < shared.triangles.size(); ++i)
        for (uint32_t& corner : shared.triangles[i])
            corner = distinct.add({corner, smoothing[i].group});
    std::vector<glm::dvec3> positions;
    positions.reserve(distinct.values().size());
    for (const glm::dvec2& placeAndGroup : distinct.values())
        positions.push_back(shared.positions[static_cast<size_t>(placeAndGroup.x)]);
    return {std::move(shared.triangles), std::move(positions)};
}

SharedCorners shareCorners(std::span<const glm::dvec3> positions, Triangles triangles) {
    DistinctValues<glm::dvec3> distinct;
    const std::vector<uint32_t> place = distinct.addAll(positions);
    std::vector<Corners> corners;
    corners.reserve(triangles.size());
    for (const Mesh::Triangle& triangle : triangles)
        corners.push_back({place[triangle.position[0]], place[triangle.position[1]],
                           place[triangle.position[2]]});
    return {std::move(corners), std::move(distinct).take()};
}

/// Appends the normals of `shared` to `normals`; the triangles for which `receives(i)` holds get
/// them.
template <typename Receives>
void addNormals(const SharedCorners& shared, Triangles triangles, std::vector<glm::dvec3>& normals,
                const Receives& receives) {
    const std::vector<glm::dvec3> made =
        areaWeightedNormals(shared.positions, std::span<const Corners>(shared.triangles));
    const auto first = static_cast<uint32_t>(normals.size());
    normals.insert(normals.end(), made.begin(), made.end());
    for (size_t i = 0; i < triangles.size(); ++i) {
        if (!receives(i))
            continue;
        const Corners& corners = shared.triangles[i];
        const bool cancelled = std::ranges::any_of(
            corners, [&](uint32_t corner) { return made[corner] == glm::dvec3(0.0); });
        for (int k = 0; k < 3; ++k)
            triangles[i].normal[k] = cancelled ? Mesh::kNoNormal : first + corners[k];
    }
}

} // namespace

void smoothNormals(std::span<const glm::dvec3> positions, Triangles triangles,
                   std::vector<glm::dvec3>& normals) {
    addNormals(shareCorners(positions, triangles), triangles, normals, [](size_t) { return true; });
}

void smoothNormals(std::span<const glm::dvec3> positions, Triangles triangles,
                   std::vector<glm::dvec3>& normals, std::span<const Smoothing> smoothing) {
    addNormals(splitByGroup(shareCorners(positions, triangles), smoothing), triangles, normals,
               [&](size_t i) { return smoothing[i].group != 0 && smoothing[i].receivesNormals; });
}

} // namespace calotype
