#pragma once

#include "scene/load_context.h"

namespace calotype {

/// Texels (fields of a checker) between the origin of texture coordinates and a lookup, up to which
/// it is off by half a texel at most. Interpolated coordinates are off by four roundings, of 2^-23
/// of themselves each; tests/extremes finds a third of that.
constexpr double kFarthestTexel = 0x1p20;

/// The height of a cylinder over its radius or the slope of a cone, and the inverse of either, up
/// to which at most one ray in a hundred mistakes one face for another. Rays start up to 14
/// roundings, 1.7e-6 of the shape's largest measure, off a face, and beyond the next where that is
/// nearer: along the rim of a flat cone at the least slope.
constexpr double kThinnestProportion = 1e4;

/// Warns, once the shapes are read, of what single precision, in which devices compute, does not
/// resolve: of textures, at the shape that reads them farthest from their origin, and of cylinders
/// and cones that are too thin, at the place of the thinnest.
void warnOfLostPrecision(LoadContext& context);

} // namespace calotype
