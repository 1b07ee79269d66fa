#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "math/bounds.h"
#include "scene/scene.h"

/// The quadrics and the disk, each in its own frame as scene/scene.h defines it.
namespace calotype::reference {

struct LocalRay {
    glm::dvec3 origin;
    glm::dvec3 direction; ///< unit length
    double tolerance;     ///< an origin within this distance of a surface is on it
};

struct LocalSurface {
    glm::dvec3 position;
    glm::dvec3 normal; ///< unit length, outward; for a disk along +Y
    glm::dvec2 uv;
    glm::dvec3 dpdu; ///< the partial derivative; zero if there is none
    glm::dvec3 dpdv; ///< likewise
};

/// The first t > 0 at which the ray crosses the surface. A ray that starts on the surface does not
/// hit it there: an outward ray leaves, an inward ray finds the far side.
std::optional<double> intersect(const Sphere& sphere, const LocalRay& ray);
std::optional<double> intersect(const Cylinder& cylinder, const LocalRay& ray);
std::optional<double> intersect(const Cone& cone, const LocalRay& ray);
std::optional<double> intersect(const Disk& disk, const LocalRay& ray);

/// The surface at its point nearest to p; p is on the surface up to rounding.
LocalSurface surfaceNear(const Sphere& sphere, const glm::dvec3& p);
LocalSurface surfaceNear(const Cylinder& cylinder, const glm::dvec3& p);
LocalSurface surfaceNear(const Cone& cone, const glm::dvec3& p);
LocalSurface surfaceNear(const Disk& disk, const glm::dvec3& p);

/// Square metres, including caps and base; for a disk one side.
double areaOf(const Sphere& sphere);
double areaOf(const Cylinder& cylinder);
double areaOf(const Cone& cone);
double areaOf(const Disk& disk);

/// The bounding box of the shape.
Bounds3d boundsOf(const Sphere& sphere);
Bounds3d boundsOf(const Cylinder& cylinder);
Bounds3d boundsOf(const Cone& cone);
Bounds3d boundsOf(const Disk& disk);

} // namespace calotype::reference
