#pragma once

#include "math/bounds.h"
#include "scene/scene.h"

namespace calotype {

/// Exact bounds of a shape, in the world.
Bounds3d shapeBounds(const Shape& shape);

/// Bounds of all shapes; empty if there are none.
Bounds3d sceneBounds(const Scene& scene);

/// The camera's position, or the point of the scene's bounds that is nearest to it.
glm::dvec3 cameraWithinBounds(const Scene& scene);

} // namespace calotype
