#pragma once

#include <string>

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns of emitters so much fainter than the scene's brightest light that the film's fixed point,
/// whose unit depends on the brightest, is too coarse for them.
void warnOfLightPrecision(const Scene& scene, Warnings& warnings);

} // namespace calotype
