#pragma once

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError unless the numbers of the camera, the film, the settings of the render and the
/// background lie in their ranges.
void requireValidCamera(const Scene& scene);

} // namespace calotype
