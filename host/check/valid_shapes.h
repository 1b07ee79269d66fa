#pragma once

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError unless the numbers of all shapes are in their ranges, the indices of meshes
/// are valid, and materials exist.
void requireValidShapes(const Scene& scene);

} // namespace calotype
