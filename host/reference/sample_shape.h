#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype::reference {

/// A point on the surface of a shape, in world space, and the unit normal there (outward, or that
/// of the front).
struct ShapePoint {
    glm::dvec3 position;
    glm::dvec3 normal;
};

/// Uniform on the shape's area; `u` in [0, 1)^2 chooses the same point as on the device.
ShapePoint samplePoint(const Sphere& sphere, const glm::dvec2& u);
ShapePoint samplePoint(const Cylinder& cylinder, const glm::dvec2& u);
ShapePoint samplePoint(const Cone& cone, const glm::dvec2& u);
ShapePoint samplePoint(const Disk& disk, const glm::dvec2& u);
ShapePoint samplePoint(const Mesh& mesh, uint32_t triangle, const glm::dvec2& u);

/// The point of the sphere that `shadingPoint`, which must be outside, sees in a direction that is
/// uniform in the cone of the sphere; its density per solid angle is sphereConePdf.
ShapePoint sampleSeenSphere(const Sphere& sphere, const glm::dvec3& shadingPoint,
                            const glm::dvec2& u);

/// 1 / the solid angle that the sphere subtends from `shadingPoint`, which must be outside.
double sphereConePdf(const Sphere& sphere, const glm::dvec3& shadingPoint);

/// True if `point` is inside. A disk or triangle has no inside.
bool contains(const Sphere& sphere, const glm::dvec3& point);
bool contains(const Cylinder& cylinder, const glm::dvec3& point);
bool contains(const Cone& cone, const glm::dvec3& point);

} // namespace calotype::reference
