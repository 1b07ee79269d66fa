#pragma once

#include <vector>

#include "scene/scene.h"

namespace calotype {

/// Of each of the scene's materials, whether any shape bears it.
std::vector<bool> borneMaterials(const Scene& scene);

} // namespace calotype
