#pragma once

#include <string>

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns where the camera's pixels are so small or its lens is so wide that single precision does
/// not tell the rays of neighbouring pixels apart.
void warnOfCameraPrecision(const Scene& scene, Warnings& warnings);

} // namespace calotype
