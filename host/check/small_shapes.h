#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Metres. In meshes smaller than this a ray's products of lengths come near the end of float's
/// range; at a hundredth of it they underflow, and rays pass through. Quadrics hold out longer.
constexpr double kSmallestShape = 1e-11;

/// A shape's size over its distance from the scene's packed origin: 128 roundings of 2^-23. Places
/// are off by a few roundings, and with them the size of the shape, of its light and its shadow: by
/// half a percent at this size, and by less as the inverse of it (SmallFarLampTest in
/// tests/extremes).
constexpr double kSmallestShare = 0x1p-16;

/// Warns of shapes that are smaller than either: in one sentence for all, at the place of the one
/// that is smallest for its distance.
void warnOfSmallShapes(const Scene& scene, Warnings& warnings);

} // namespace calotype
