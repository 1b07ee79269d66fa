#pragma once

#include <vector>

#include "scene/scene.h"

namespace calotype {

/// For each of Scene::materials, whether a shape uses it.
std::vector<bool> usedMaterials(const Scene& scene);

} // namespace calotype
