#pragma once

#include <string>

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns of what shines so much fainter than the scene's brightest light that the film, whose fixed
/// point is set by that one, does not hold both well.
void warnOfLightPrecision(const Scene& scene, Warnings& warnings);

} // namespace calotype
