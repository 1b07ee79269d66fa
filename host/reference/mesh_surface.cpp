#include "reference/mesh_surface.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace calotype::reference {
namespace {

/// The first corner plus edges: for far corners, rounding could exceed the size of the triangle.
glm::dvec3 positionAt(const Corners& corners, const glm::dvec3& weights) {
    return corners[0] +
           (weights.y * (corners[1] - corners[0]) + weights.z * (corners[2] - corners[0]));
}

/// p(u, v) is linear: edge_i = dp/du u_i + dp/dv v_i for the two edges from the first corner, with
/// (u_i, v_i) their extent in texture space. Solved by Cramer's rule.
void setCoordinates(Surface& surface, const Corners& corners, const glm::dvec2 (&uv)[3],
                    const glm::dvec3& weights) {
    surface.uv = weights.x * uv[0] + weights.y * uv[1] + weights.z * uv[2];
    const glm::dvec2 uv1 = uv[1] - uv[0];
    const glm::dvec2 uv2 = uv[2] - uv[0];
    const double determinant = uv1.x * uv2.y - uv2.x * uv1.y;
    if (determinant == 0.0)
        return;
    const glm::dvec3 edge1 = corners[1] - corners[0];
    const glm::dvec3 edge2 = corners[2] - corners[0];
    surface.dpdu = (uv2.y * edge1 - uv1.y * edge2) / determinant;
    surface.dpdv = (uv1.x * edge2 - uv2.x * edge1) / determinant;
}

/// The smooth surface through the corners, perpendicular to their normals: the mean of the point's
/// projections onto the corners' tangent planes, where the point is below them on the viewer's side
/// (Hanika 2021, "Hacking the Shadow Terminator").
glm::dvec3 fromTriangleToSmooth(const glm::dvec3& position, const Corners& corners,
                                const glm::dvec3 (&normals)[3], const glm::dvec3& weights) {
    glm::dvec3 sum(0.0);
    for (int k = 0; k < 3; ++k) {
        const double height = glm::dot(position - corners[k], normals[k]);
        sum -= weights[k] * std::min(height, 0.0) * normals[k];
    }
    return sum;
}

void smoothen(Surface& surface, const Corners& corners, const glm::dvec3 (&normals)[3],
              const glm::dvec3& weights, const glm::dvec3& rayDirection) {
    const glm::dvec3 mean =
        weights.x * normals[0] + weights.y * normals[1] + weights.z * normals[2];
    if (mean == glm::dvec3(0.0))
        return;
    const double outward = glm::dot(mean, surface.ng) < 0.0 ? -1.0 : 1.0;
    surface.ns = outward * glm::normalize(mean);
    const double viewersSide = glm::dot(rayDirection, surface.ng) > 0.0 ? -1.0 : 1.0;
    const double turn = outward * viewersSide;
    const glm::dvec3 towardsViewer[3] = {turn * normals[0], turn * normals[1], turn * normals[2]};
    const glm::dvec3 toSmooth =
        fromTriangleToSmooth(surface.position, corners, towardsViewer, weights);
    const bool isConvex = viewersSide * glm::dot(toSmooth, surface.ng) > 0.0;
    if (!isConvex)
        return;
    surface.toSmooth = toSmooth;
    surface.horizon = surface.ns;
}

} // namespace

Corners cornersOf(const Mesh& mesh, const Mesh::Triangle& triangle) {
    return {mesh.positions[triangle.position[0]], mesh.positions[triangle.position[1]],
            mesh.positions[triangle.position[2]]};
}

glm::dvec2 uvAt(const Mesh& mesh, const Mesh::Triangle& triangle, const glm::dvec3& weights) {
    if (triangle.uv[0] == Mesh::kNoUv)
        return glm::dvec2(0.0);
    return weights.x * mesh.uvs[triangle.uv[0]] + weights.y * mesh.uvs[triangle.uv[1]] +
           weights.z * mesh.uvs[triangle.uv[2]];
}

Surface surfaceAt(const Mesh& mesh, const Mesh::Triangle& triangle, const glm::dvec3& weights,
                  const glm::dvec3& rayDirection) {
    const Corners corners = cornersOf(mesh, triangle);
    Surface surface{};
    surface.position = positionAt(corners, weights);
    surface.ng = normalOf(corners);
    surface.ns = surface.ng;
    surface.horizon = surface.ng;
    if (triangle.uv[0] != Mesh::kNoUv) {
        const glm::dvec2 uv[3] = {mesh.uvs[triangle.uv[0]], mesh.uvs[triangle.uv[1]],
                                  mesh.uvs[triangle.uv[2]]};
        setCoordinates(surface, corners, uv, weights);
    }
    if (triangle.normal[0] != Mesh::kNoNormal) {
        const glm::dvec3 normals[3] = {mesh.normals[triangle.normal[0]],
                                       mesh.normals[triangle.normal[1]],
                                       mesh.normals[triangle.normal[2]]};
        smoothen(surface, corners, normals, weights, rayDirection);
    }
    return surface;
}

} // namespace calotype::reference
