#include "accel/primitive.h"

#include <atomic>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "base/parallel_chunks.h"
#include "math/outward_rounding.h"
#include "scene/scene_bounds.h"

namespace calotype {
namespace {

/// How far the packed quadric, and hits computed on it, may be outside the exact one, relative to
/// its coordinates: rounding of the parameters plus the error bound of quadricPoint
/// (shapes/quadric.glsl), 16 operations of 2^-23 in all, times two.
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

/// The kernels form cubes of lengths; beyond this limit they approach the end of float's range.
constexpr float kLargestCoordinate = 1e12f;

bool isPackable(const Bounds3f& bounds) {
    const glm::vec3 magnitude = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
    return glm::all(glm::lessThanEqual(magnitude, glm::vec3(kLargestCoordinate))); // false for NaN
}

void require(bool isPackable, const Shape& shape) {
    if (!isPackable)
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

std::vector<Primitive> collectPrimitives(const Scene& scene, const glm::dvec3& origin,
                                         uint32_t threads) {
    std::vector<Primitive> primitives;
    for (uint32_t shapeIndex = 0; shapeIndex < scene.shapes.size(); ++shapeIndex) {
        const Shape& shape = scene.shapes[shapeIndex];
        const Mesh* mesh = std::get_if<Mesh>(&shape.geometry);
        if (!mesh) {
            const Bounds3f bounds = packedQuadricBounds(shape, origin);
            require(isPackable(bounds), shape);
            primitives.push_back({bounds, shapeIndex, 0, PrimitiveKind::Quadric});
            continue;
        }
        const size_t begin = primitives.size();
        primitives.resize(begin + mesh->triangles.size());
        std::atomic<bool> arePackable = true;
        parallelChunks(mesh->triangles.size(), threads, [&](uint64_t first, uint64_t last) {
            for (auto t = static_cast<uint32_t>(first); t < last; ++t) {
                Bounds3f bounds;
                for (const uint32_t index : mesh->triangles[t].position)
                    bounds.extend(packPosition(mesh->positions[index], origin));
                if (!isPackable(bounds))
                    arePackable = false;
                primitives[begin + t] = {bounds, shapeIndex, t, PrimitiveKind::Triangle};
            }
        });
        require(arePackable, shape);
    }
    return primitives;
}

} // namespace calotype
