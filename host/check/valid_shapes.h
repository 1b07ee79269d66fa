#pragma once

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError unless the numbers of all shapes lie in their ranges, meshes index what they
/// have, and materials exist.
void requireValidShapes(const Scene& scene);

} // namespace calotype
