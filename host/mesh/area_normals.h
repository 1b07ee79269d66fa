#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype {

/// Largest absolute value of the three; to scale vectors without overflow.
double largestComponent(const glm::dvec3& v);

/// For each of `positions`, the mean of the normals of the triangles that use it, weighted by area
/// and normalised; zero if the normals cancel or there is no triangle.
std::vector<glm::dvec3> areaWeightedNormals(std::span<const glm::dvec3> positions,
                                            std::span<const Mesh::Triangle> triangles);

/// The numbers of a triangle's corners among some positions.
using Corners = std::array<uint32_t, 3>;

/// The same for triangles that are corners alone.
std::vector<glm::dvec3> areaWeightedNormals(std::span<const glm::dvec3> positions,
                                            std::span<const Corners> triangles);

} // namespace calotype
