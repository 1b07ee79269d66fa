#include "read/framed_points.h"

#include <algorithm>
#include <functional>

#include <glm/geometric.hpp>

#include "check/closed_parts.h"
#include "math/bounds.h"

namespace calotype {
namespace {

/// Parts count as many times larger beyond this factor.
constexpr double kManyTimes = 8.0;

/// A part is flat if its extent along an axis is a smaller share of its diagonal.
constexpr double kFlatShare = 0.01;

double diagonalOf(const Bounds3d& bounds) {
    return bounds.isEmpty() ? 0.0 : glm::length(bounds.extent());
}

bool isFlat(const Bounds3d& bounds) {
    const glm::dvec3 extent = bounds.extent();
    return std::min({extent.x, extent.y, extent.z}) < kFlatShare * diagonalOf(bounds);
}

std::vector<MeshPart> largestFirst(const Mesh& mesh) {
    uint32_t materials = 0;
    for (const Mesh::Triangle& triangle : mesh.triangles)
        materials = std::max(materials, triangle.material + 1);
    std::vector<MeshPart> parts = partsOf(mesh, std::vector<bool>(materials, true));
    std::ranges::sort(parts, std::greater(),
                      [](const MeshPart& part) { return diagonalOf(part.bounds); });
    return parts;
}

} // namespace

FramedPoints framedPoints(const Mesh& mesh) {
    const std::vector<MeshPart> parts = largestFirst(mesh);
    std::vector<Bounds3d> fromHere(parts.size() + 1); // bounds of each part and all smaller ones
    for (size_t k = parts.size(); k-- > 0;) {
        fromHere[k] = fromHere[k + 1];
        fromHere[k].extend(parts[k].bounds);
    }
    // The first part that is many times larger than all smaller ones, and whether it and those
    // before it are left out.
    FramedPoints framed;
    size_t firstShown = 0;
    size_t triangles = 0;
    bool areFlat = true;
    for (size_t k = 0; k + 1 < parts.size(); ++k) {
        triangles += parts[k].triangles.size();
        areFlat = areFlat && isFlat(parts[k].bounds);
        const double rest = diagonalOf(fromHere[k + 1]);
        if (rest == 0.0 || diagonalOf(parts[k].bounds) <= kManyTimes * rest)
            continue;
        framed.ratio = diagonalOf(parts[0].bounds) / rest;
        framed.leavesOutLargest =
            !isFlat(fromHere[k + 1]) && (areFlat || 2 * triangles < mesh.triangles.size());
        firstShown = framed.leavesOutLargest ? k + 1 : 0;
        break;
    }
    for (size_t k = firstShown; k < parts.size(); ++k)
        for (const uint32_t index : parts[k].triangles)
            for (const uint32_t corner : mesh.triangles[index].position)
                framed.points.push_back(mesh.positions[corner]);
    return framed;
}

} // namespace calotype
