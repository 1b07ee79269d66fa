#pragma once

#include <string>

#include "scene/load_context.h"

namespace calotype {

/// Warns of what shines so much fainter than the scene's brightest light that the film, whose fixed
/// point is set by that one, does not hold both well. `path` is the scene file's.
void warnOfFaintLights(LoadContext& context, const std::string& path);

} // namespace calotype
