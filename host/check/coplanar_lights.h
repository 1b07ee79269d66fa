#pragma once

#include <string>

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns of lights whose flat part is seen and lies in the plane of another flat shape that covers
/// it, such as a ceiling: rounding decides, point by point, which of the two a ray meets. A few are
/// named, others counted. Scenes of more than 10^7 pairs of a light's triangle and another are not
/// looked through.
void warnOfCoplanarLights(const Scene& scene, Warnings& warnings);

} // namespace calotype
