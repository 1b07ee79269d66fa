#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "math/bounds.h"
#include "scene/scene.h"

namespace calotype {

/// Triangles of a mesh that are connected by shared positions.
struct MeshPart {
    const Mesh* mesh = nullptr;
    std::vector<uint32_t> triangles; ///< indices into Mesh::triangles
    Bounds3d bounds;
    bool isClosed = false;   ///< every edge is used an even number of times
    bool isOriented = false; ///< every edge is used as often one way as the other
    double volume = 0.0;     ///< if oriented; negative if the faces are wound inward
    double area = 0.0;
};

/// The parts of those triangles for which `isChosen` holds, by the index of their material.
std::vector<MeshPart> partsOf(const Mesh& mesh, const std::vector<bool>& isChosen);

/// How often the part winds around a point that is not on it: 1 inside a part that is closed and
/// wound outward, -1 inside one that is wound inward, 0 outside; between for parts with holes.
double windingNumber(const MeshPart& part, const glm::dvec3& point);

} // namespace calotype
