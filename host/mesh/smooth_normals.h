#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype {

/// How one triangle takes part in smoothNormals.
struct Smoothing {
    uint32_t group = 0;          ///< triangles of the same group are one surface; 0 is none
    bool receivesNormals = true; ///< false: keeps its normals, but counts for its neighbours
};

/// Gives triangles normals that are appended to `normals`: at each position, by its value, the mean
/// of the normals of all triangles, weighted by area. Triangles become flat if the normals at one
/// of their positions cancel.
void smoothNormals(std::span<const glm::dvec3> positions, std::span<Mesh::Triangle> triangles,
                   std::vector<glm::dvec3>& normals);

/// The same for each group by itself. `smoothing` has an entry for each of `triangles`; those of no
/// group stay as they are.
void smoothNormals(std::span<const glm::dvec3> positions, std::span<Mesh::Triangle> triangles,
                   std::vector<glm::dvec3>& normals, std::span<const Smoothing> smoothing);

} // namespace calotype
