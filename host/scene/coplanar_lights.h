#pragma once

#include <string>

#include "scene/load_context.h"

namespace calotype {

/// Warns of lights whose flat part is seen and lies in the plane of another flat shape that covers
/// it, such as a ceiling: rounding decides, point by point, which of the two a ray meets. A few are
/// named, others counted. Scenes of more than 10^7 pairs of a light's triangle and another are not
/// looked through. `path` is the scene file's or the model's.
void warnOfCoplanarLights(LoadContext& context, const std::string& path);

} // namespace calotype
