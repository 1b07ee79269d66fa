#pragma once

#include <string>

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns of lights with a visible flat part in the plane of another flat shape that covers it, such
/// as a ceiling: at each point, rounding decides which of the two a ray hits. Names a few of them
/// and counts the others. Scenes with more than 10^7 pairs of a light's triangle and another
/// triangle are not checked.
void warnOfCoplanarLights(const Scene& scene, Warnings& warnings);

} // namespace calotype
