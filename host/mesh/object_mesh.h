#pragma once

#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype {

/// Triangles in object space and their vertex data. Does not own the memory.
struct ObjectMesh {
    std::span<const glm::dvec3> positions;
    std::span<const glm::dvec3> normals; ///< of any length; those in use must not be zero
    std::span<const glm::dvec2> uvs;
    std::span<const Mesh::Triangle> triangles;
};

} // namespace calotype
