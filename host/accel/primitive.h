#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "base/parallel_for.h"
#include "math/bounds.h"
#include "scene/scene.h"

namespace calotype {

enum class PrimitiveKind : uint8_t { Triangle, Quadric };

/// A primitive in a leaf of the BVH. Its number is its index in the order of the scene file.
struct Primitive {
    Bounds3f bounds;       ///< contains the packed primitive, in coordinates relative to the origin
    uint32_t shape = 0;    ///< index into Scene::shapes
    uint32_t triangle = 0; ///< index into the mesh's triangles
    PrimitiveKind kind = PrimitiveKind::Triangle;
};

/// A world position in the device's coordinates: relative to `origin`, rounded to float.
inline glm::vec3 packPosition(const glm::dvec3& world, const glm::dvec3& origin) {
    return glm::vec3(world - origin);
}

/// The origin of the packed scene: the camera, or the nearest point of the scene's bounds. So
/// neither a scene far from the world's origin nor a camera far from the scene costs precision.
glm::dvec3 packingOrigin(const Scene& scene);

/// All primitives of the scene in its order. Throws SceneError with the shape's place if
/// coordinates are too large for the device's arithmetic.
std::vector<Primitive> collectPrimitives(const Scene& scene, const glm::dvec3& origin,
                                         uint32_t threads = allCores());

} // namespace calotype
