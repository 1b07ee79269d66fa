#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Texels (fields of a checker) between the origin of texture coordinates and a lookup, up to which
/// it is off by half a texel at most. Interpolated coordinates are off by four roundings, of 2^-23
/// of themselves each; tests/extremes finds a third of that.
constexpr double kFarthestTexel = 0x1p20;

/// Warns of textures that are read farther out: in one sentence for each shape that reads some of
/// them farthest.
void warnOfTexturePrecision(const Scene& scene, Warnings& warnings);

} // namespace calotype
