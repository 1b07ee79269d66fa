#pragma once

#include <functional>
#include <span>

#include "accel/bvh.h"

namespace calotype {

/// Builds the report's tree: the primitives are split into two halves of equal count by the centres
/// of their boxes along one axis, until a leaf holds at most kMaxLeafPrimitives of one kind. The
/// axis is the one that makes the halves' boxes smallest, which the report leaves open. The depth
/// is at most log2(primitives) + 2. Deterministic. `onProgress`, if given, hears the share of
/// primitives already in leaves.
Bvh buildMedianSplit(std::span<const Primitive> primitives,
                     const std::function<void(double)>& onProgress = {});

} // namespace calotype
