#pragma once

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError unless the numbers of the camera, the film, the render settings and the
/// background are in their ranges.
void requireValidCamera(const Scene& scene);

} // namespace calotype
