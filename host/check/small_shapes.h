#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Metres. In smaller meshes, a ray's products of lengths approach the end of float's range; at a
/// hundredth of this size they underflow, and rays pass through. Quadrics are less sensitive.
constexpr double kSmallestShape = 1e-11;

/// A shape's size over its distance from the scene's packed origin: 128 roundings of 2^-23.
/// Positions have an error of a few roundings, which changes the size of the shape, of its light
/// and of its shadow: by half a percent at this size, and inversely proportional to the size
/// (SmallFarLampTest in tests/extremes).
constexpr double kSmallestShare = 0x1p-16;

/// Warns of shapes below either limit: in one sentence for all, at the place of the shape that is
/// smallest for its distance.
void warnOfSmallShapes(const Scene& scene, Warnings& warnings);

} // namespace calotype
