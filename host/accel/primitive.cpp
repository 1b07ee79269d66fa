#include "accel/primitive.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "math/outward_rounding.h"
#include "scene/scene_bounds.h"

namespace calotype {
namespace {

/// How far the packed quadric, and the hits computed on it, may lie outside the exact one, relative
/// to its coordinates: rounding of the parameters plus the error bound of quadricPoint
/// (shapes/quadric.glsl), 16 operations of 2^-23 in all, doubled.
constexpr double kQuadricSlack = 32.0 / (1 << 23);

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

glm::dvec3 packingOrigin(const Scene& scene) {
    const glm::dvec3 origin = cameraWithinBounds(scene);
    if (glm::distance(scene.camera.position, origin) > kLargestCoordinate)
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
