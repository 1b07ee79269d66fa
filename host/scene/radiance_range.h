#pragma once

#include <string>

#include "scene/scene.h"

namespace calotype {

/// Throws SceneError where something shines with a radiance whose largest channel is neither 0 nor
/// from 1e-30 to 1e30 W/(m^2 sr): what float holds with room for sums and products. `path` is the
/// scene file's or the model's.
void requireRadianceInRange(const Scene& scene, const std::string& path);

} // namespace calotype
