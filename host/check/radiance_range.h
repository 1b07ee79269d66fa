#pragma once

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError if something emits a radiance whose largest channel is neither 0 nor in
/// [1e-30, 1e30] W/(m^2 sr): the range of float, with room for sums and products.
void requireRadianceInRange(const Scene& scene);

} // namespace calotype
