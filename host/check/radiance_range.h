#pragma once

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError where something shines with a radiance whose largest channel is neither 0 nor
/// from 1e-30 to 1e30 W/(m^2 sr): what float holds with room for sums and products.
void requireRadianceInRange(const Scene& scene);

} // namespace calotype
