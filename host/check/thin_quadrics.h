#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// The limit for the height of a cylinder over its radius, for the slope of a cone, and for their
/// inverses. At the limit, one in 100 of the inward rays starts beyond the opposite face. Rays
/// start up to 14 roundings, 1.7e-6 of the shape's largest extent, off a face. That is too far
/// where the opposite face is nearer: along the rim of a flat cone at the least slope.
constexpr double kThinnestProportion = 1e4;

/// Warns of cylinders and cones that are thinner: in one sentence for all, at the place of the
/// thinnest.
void warnOfThinQuadrics(const Scene& scene, Warnings& warnings);

} // namespace calotype
