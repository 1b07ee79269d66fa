#include "read/framed_points.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

#include "math/bounds.h"

namespace calotype {
namespace {

/// A part is left out if it is more than this many times larger than all smaller ones together.
constexpr double kMostTimesLarger = 8.0;

/// Triangles that share corners, directly or through others.
struct Part {
    Bounds3d bounds;
    size_t triangles = 0;
};

double diagonalOf(const Bounds3d& bounds) {
    return bounds.isEmpty() ? 0.0 : glm::length(bounds.extent());
}

/// For each position, the least position of its part (union-find).
std::vector<uint32_t> partsOf(const Mesh& mesh) {
    std::vector<uint32_t> root(mesh.positions.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&](uint32_t i) {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    };
    for (const Mesh::Triangle& triangle : mesh.triangles)
        for (int corner = 1; corner < 3; ++corner) {
            const uint32_t a = find(triangle.position[0]);
            const uint32_t b = find(triangle.position[corner]);
            root[std::max(a, b)] = std::min(a, b);
        }
    for (uint32_t i = 0; i < root.size(); ++i)
        root[i] = find(i);
    return root;
}

} // namespace

FramedPoints framedPoints(const Mesh& mesh) {
    const std::vector<uint32_t> partOf = partsOf(mesh);
    std::vector<Part> parts(mesh.positions.size()); // most are empty
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        parts[partOf[i]].bounds.extend(mesh.positions[i]);
    for (const Mesh::Triangle& triangle : mesh.triangles)
        ++parts[partOf[triangle.position[0]]].triangles;

    // The parts with triangles, the largest first, and the bounds of each with all smaller ones.
    std::vector<uint32_t> order;
    for (uint32_t i = 0; i < parts.size(); ++i)
        if (parts[i].triangles > 0)
            order.push_back(i);
    std::ranges::sort(order, std::greater(),
                      [&](uint32_t i) { return diagonalOf(parts[i].bounds); });
    std::vector<Bounds3d> fromHere(order.size() + 1);
    for (size_t k = order.size(); k-- > 0;) {
        fromHere[k] = fromHere[k + 1];
        fromHere[k].extend(parts[order[k]].bounds);
    }

    // Leave out the first parts, which must hold less than half of the triangles.
    FramedPoints framed;
    std::vector<bool> isLeftOut(parts.size(), false);
    size_t triangles = 0;
    for (size_t k = 0; k + 1 < order.size(); ++k) {
        triangles += parts[order[k]].triangles;
        if (2 * triangles >= mesh.triangles.size())
            break;
        const double rest = diagonalOf(fromHere[k + 1]);
        if (diagonalOf(parts[order[k]].bounds) <= kMostTimesLarger * rest || rest == 0.0)
            continue;
        for (size_t left = 0; left <= k; ++left)
            isLeftOut[order[left]] = true;
        framed.scaleOfTheRest = diagonalOf(parts[order[0]].bounds) / rest;
        break;
    }
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        if (!isLeftOut[partOf[i]] && parts[partOf[i]].triangles > 0)
            framed.points.push_back(mesh.positions[i]);
    return framed;
}

} // namespace calotype
