#pragma once

#include "accel/primitive.h"
#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace calotype {

/// A triangle of packed corners, with its normal, zero where these have no area. The rest is left
/// at zero, the light at kNone.
shared::Triangle packTriangle(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2);

/// `number` is the primitive's index in the scene's order. The normal is that of the mesh's own
/// corners where the packed ones have no area. The light is left at kNone.
shared::Triangle packTriangle(const Mesh& mesh, uint32_t triangle, const glm::dvec3& origin,
                              uint32_t number);

/// Zero normals where the triangle has none of its own.
shared::TriangleNormals packTriangleNormals(const Mesh& mesh, uint32_t triangle);

/// Zero where the triangle has none.
shared::TriangleUvs packTriangleUvs(const Mesh& mesh, uint32_t triangle);

/// Any shape but a mesh. The light is left at kNone.
shared::Quadric packQuadric(const Shape& shape, const glm::dvec3& origin, uint32_t number);

/// Area of the packed surface, m^2.
double areaOf(const shared::Triangle& triangle);
double areaOf(const shared::Quadric& quadric);

} // namespace calotype
