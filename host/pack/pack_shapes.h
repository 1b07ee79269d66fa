#pragma once

#include "accel/primitive.h"
#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace calotype {

/// `number` is the primitive's index in the scene's order. The light is left at kNone.
gpu::Triangle packTriangle(const Mesh& mesh, uint32_t triangle, const glm::dvec3& origin,
                           uint32_t number);

/// Zero normals where the triangle has none of its own.
gpu::TriangleNormals packTriangleNormals(const Mesh& mesh, uint32_t triangle);

/// Zero where the triangle has none.
gpu::TriangleUvs packTriangleUvs(const Mesh& mesh, uint32_t triangle);

/// Any shape but a mesh. The light is left at kNone.
gpu::Quadric packQuadric(const Shape& shape, const glm::dvec3& origin, uint32_t number);

/// Area of the packed surface, m^2.
double areaOf(const gpu::Triangle& triangle);
double areaOf(const gpu::Quadric& quadric);

} // namespace calotype
