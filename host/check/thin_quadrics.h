#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// The height of a cylinder over its radius or the slope of a cone, and the inverse of either, up
/// to which one in 70 of the rays inward starts beyond the far face. Rays start up to 14
/// roundings, 1.7e-6 of the shape's largest measure, off a face, and beyond the next where that is
/// nearer: along the rim of a flat cone at the least slope.
constexpr double kThinnestProportion = 1e4;

/// Warns of cylinders and cones that are thinner: in one sentence for all, at the place of the
/// thinnest.
void warnOfThinQuadrics(const Scene& scene, Warnings& warnings);

} // namespace calotype
