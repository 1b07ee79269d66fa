#include "accel/primitive.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "math/outward_rounding.h"

namespace calotype {
namespace {

/// How far the packed quadric, and the hits computed on it, may lie outside the exact one, relative
/// to its coordinates: rounding of the parameters plus the error bound of quadricPoint
/// (shapes/quadric.glsl), 16 operations of 2^-23 in all, doubled.
constexpr double kQuadricSlack = 32.0 / (1 << 23);

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

Bounds3d shapeBounds(const Shape& shape) {
    return std::visit([](const auto& geometry) { return boundsOf(geometry); }, shape.geometry);
}

Bounds3f packedQuadricBounds(const Shape& shape, const glm::dvec3& origin) {
    Bounds3d bounds = shapeBounds(shape);
    const glm::dvec3 size = bounds.extent();
    bounds.lower -= origin;
    bounds.upper -= origin;
    const glm::dvec3 magnitude = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper)) +
                                 glm::max(glm::max(size.x, size.y), size.z);
    bounds.lower -= kQuadricSlack * magnitude;
    bounds.upper += kQuadricSlack * magnitude;
    return roundOutward(bounds);
}

/// The kernels form cubes of lengths, which beyond this come near the end of float's range.
constexpr float kLargestCoordinate = 1e12f;

void requirePackable(const Bounds3f& bounds, const Shape& shape) {
    const glm::vec3 magnitude = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
    const float largest = std::max({magnitude.x, magnitude.y, magnitude.z});
    if (!(largest <= kLargestCoordinate))
        throw SceneError(shape.place,
                         "reaches more than 1e12 metres from the camera or the scene's "
                         "near side; scale the scene down");
}

} // namespace

Bounds3d sceneBounds(const Scene& scene) {
    Bounds3d bounds;
    for (const Shape& shape : scene.shapes)
        bounds.extend(shapeBounds(shape));
    return bounds;
}

glm::dvec3 packingOrigin(const Scene& scene) {
    const Bounds3d bounds = sceneBounds(scene);
    const glm::dvec3 camera = scene.camera.position;
    if (bounds.isEmpty())
        return camera;
    const glm::dvec3 origin = glm::clamp(camera, bounds.lower, bounds.upper);
    if (glm::distance(camera, origin) > kLargestCoordinate)
        throw SceneError("the camera", "is more than 1e12 metres from the scene; bring it closer");
    return origin;
}

std::vector<Primitive> collectPrimitives(const Scene& scene, const glm::dvec3& origin) {
    std::vector<Primitive> primitives;
    for (uint32_t shapeIndex = 0; shapeIndex < scene.shapes.size(); ++shapeIndex) {
        const Shape& shape = scene.shapes[shapeIndex];
        const Mesh* mesh = std::get_if<Mesh>(&shape.geometry);
        if (!mesh) {
            const Bounds3f bounds = packedQuadricBounds(shape, origin);
            requirePackable(bounds, shape);
            primitives.push_back({bounds, shapeIndex, 0, PrimitiveKind::Quadric});
            continue;
        }
        primitives.reserve(primitives.size() + mesh->triangles.size());
        for (uint32_t t = 0; t < mesh->triangles.size(); ++t) {
            Bounds3f bounds;
            for (const uint32_t index : mesh->triangles[t].position)
                bounds.extend(packPosition(mesh->positions[index], origin));
            requirePackable(bounds, shape);
            primitives.push_back({bounds, shapeIndex, t, PrimitiveKind::Triangle});
        }
    }
    return primitives;
}

} // namespace calotype
