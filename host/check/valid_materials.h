#pragma once

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError unless every texture has an image, and the numbers of textures and materials
/// are in their ranges (see materialKinds) and refer to existing textures.
void requireValidMaterials(const Scene& scene);

} // namespace calotype
