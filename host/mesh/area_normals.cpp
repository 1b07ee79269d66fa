#include "mesh/area_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace calotype {
namespace {

/// Relative to the summed areas: a smaller sum of normals is only rounding.
constexpr double kCancelled = 1e-12;

/// A power of two that scales the positions to a size near one, so that areas do not overflow or
/// underflow.
double unitScale(std::span<const glm::dvec3> positions) {
    double size = 0.0;
    for (const glm::dvec3& p : positions)
        size = std::max(size, largestComponent(p - positions.front()));
    return size > 0.0 ? std::ldexp(1.0, std::clamp(-std::ilogb(size), -1000, 1000)) : 1.0;
}

std::span<const uint32_t, 3> cornersOf(const Mesh::Triangle& triangle) { return triangle.position; }
std::span<const uint32_t, 3> cornersOf(const Corners& triangle) { return triangle; }

template <typename Triangle>
std::vector<glm::dvec3> meanNormals(std::span<const glm::dvec3> positions,
                                    std::span<const Triangle> triangles) {
    const double scale = unitScale(positions);
    std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0.0));
    std::vector<double> areas(positions.size(), 0.0);
    for (const Triangle& triangle : triangles) {
        const std::span<const uint32_t, 3> corners = cornersOf(triangle);
        const glm::dvec3& a = positions[corners[0]];
        const glm::dvec3 ab = (positions[corners[1]] - a) * scale;
        const glm::dvec3 ac = (positions[corners[2]] - a) * scale;
        const glm::dvec3 normal = glm::cross(ab, ac);
        for (const uint32_t corner : corners) {
            normals[corner] += normal;
            areas[corner] += largestComponent(normal);
        }
    }
    for (size_t i = 0; i < normals.size(); ++i) {
        const double size = largestComponent(normals[i]);
        const bool cancelled = !(size > kCancelled * areas[i]) || !std::isfinite(size);
        normals[i] = cancelled ? glm::dvec3(0.0) : glm::normalize(normals[i] / size);
    }
    return normals;
}

} // namespace

double largestComponent(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

std::vector<glm::dvec3> areaWeightedNormals(std::span<const glm::dvec3> positions,
                                            std::span<const Mesh::Triangle> triangles) {
    return meanNormals(positions, triangles);
}

std::vector<glm::dvec3> areaWeightedNormals(std::span<const glm::dvec3> positions,
                                            std::span<const Corners> triangles) {
    return meanNormals(positions, triangles);
}

} // namespace calotype
