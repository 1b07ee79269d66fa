#pragma once

#include <string>

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns if the camera's pixels are so small or its lens is so wide that single precision cannot
/// separate the rays of neighbouring pixels.
void warnOfCameraPrecision(const Scene& scene, Warnings& warnings);

} // namespace calotype
