#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns if nothing emits light.
void warnOfBlackPicture(const Scene& scene, Warnings& warnings);

} // namespace calotype
