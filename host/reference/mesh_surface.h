#pragma once

#include <glm/vec3.hpp>

#include "reference/surface.h"
#include "reference/triangle.h"
#include "scene/scene.h"

namespace calotype::reference {

Corners cornersOf(const Mesh& mesh, const Mesh::Triangle& triangle);

/// Texture coordinates at these weights of the corners; zero if the mesh has none.
glm::dvec2 uvAt(const Mesh& mesh, const Mesh::Triangle& triangle, const glm::dvec3& weights);

/// The surface of the mesh where a ray of the given direction hits the triangle, without material
/// and primitive.
Surface surfaceAt(const Mesh& mesh, const Mesh::Triangle& triangle, const glm::dvec3& weights,
                  const glm::dvec3& rayDirection);

} // namespace calotype::reference
