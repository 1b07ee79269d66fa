#include "scene/scene_bounds.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

namespace calotype {
namespace {

/// Half extents of a disk: along each axis, radius times the sine of the angle to the normal.
glm::dvec3 diskExtent(const glm::dvec3& normal, double radius) {
    return radius * glm::sqrt(glm::max(glm::dvec3(1.0) - normal * normal, glm::dvec3(0.0)));
}

Bounds3d around(const glm::dvec3& center, const glm::dvec3& halfExtent) {
    return {center - halfExtent, center + halfExtent};
}

Bounds3d boundsOf(const Sphere& sphere) {
    return around(sphere.worldFromObject.translation, glm::dvec3(sphere.radius));
}

Bounds3d boundsOf(const Cylinder& cylinder) {
    const glm::dvec3 axis = cylinder.worldFromObject.rotation[1];
    return around(cylinder.worldFromObject.translation,
                  0.5 * cylinder.height * glm::abs(axis) + diskExtent(axis, cylinder.radius));
}

Bounds3d boundsOf(const Cone& cone) {
    const glm::dvec3 axis = cone.worldFromObject.rotation[1];
    const glm::dvec3 apex = cone.worldFromObject.translation;
    Bounds3d bounds =
        around(apex + cone.height * axis, diskExtent(axis, cone.slope * glm::abs(cone.height)));
    bounds.extend(apex);
    return bounds;
}

Bounds3d boundsOf(const Disk& disk) {
    return around(disk.worldFromObject.translation,
                  diskExtent(disk.worldFromObject.rotation[1], disk.radius));
}

Bounds3d boundsOf(const Mesh& mesh) {
    Bounds3d bounds;
    for (const Mesh::Triangle& triangle : mesh.triangles)
        for (const uint32_t index : triangle.position)
            bounds.extend(mesh.positions[index]);
    return bounds;
}

} // namespace

Bounds3d shapeBounds(const Shape& shape) {
    return std::visit([](const auto& geometry) { return boundsOf(geometry); }, shape.geometry);
}

Bounds3d sceneBounds(const Scene& scene) {
    Bounds3d bounds;
    for (const Shape& shape : scene.shapes)
        bounds.extend(shapeBounds(shape));
    return bounds;
}

glm::dvec3 cameraWithinBounds(const Scene& scene) {
    const Bounds3d bounds = sceneBounds(scene);
    const glm::dvec3& camera = scene.camera.position;
    return bounds.isEmpty() ? camera : glm::clamp(camera, bounds.lower, bounds.upper);
}

} // namespace calotype
