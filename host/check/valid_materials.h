#pragma once

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError unless every texture has an image, and the numbers of textures and materials
/// lie in their ranges (see materialKinds) and name textures that exist.
void requireValidMaterials(const Scene& scene);

} // namespace calotype
