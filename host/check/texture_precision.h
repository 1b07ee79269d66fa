#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Texels (fields of a checker) between the origin of texture coordinates and a lookup. Up to this
/// number the error is half a texel at most: interpolated coordinates have an error of four
/// roundings, 2^-23 of themselves each; tests/extremes measures a third of that.
constexpr double kFarthestTexel = 0x1p20;

/// Warns of textures that are read farther out: one sentence for each shape with the farthest
/// lookup of some texture.
void warnOfTexturePrecision(const Scene& scene, Warnings& warnings);

} // namespace calotype
