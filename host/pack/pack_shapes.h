#pragma once

#include "accel/primitive.h"
#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace calotype {

/// A triangle from packed corners, with its normal; zero if it has no area. The other fields are 0,
/// the light is kNone.
shared::Triangle packTriangle(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2);

/// `number` is the primitive's index in the scene's order. If the packed corners have no area, the
/// normal is that of the mesh's own corners. The light is kNone.
shared::Triangle packTriangle(const Mesh& mesh, uint32_t triangle, const glm::dvec3& origin,
                              uint32_t number);

/// Zero normals if the triangle has no shading normals.
shared::TriangleNormals packTriangleNormals(const Mesh& mesh, uint32_t triangle);

/// Zero if the triangle has none.
shared::TriangleUvs packTriangleUvs(const Mesh& mesh, uint32_t triangle);

/// Any shape except a mesh. The light is kNone.
shared::Quadric packQuadric(const Shape& shape, const glm::dvec3& origin, uint32_t number);

/// Area of the packed surface, m^2.
double areaOf(const shared::Triangle& triangle);
double areaOf(const shared::Quadric& quadric);

} // namespace calotype
