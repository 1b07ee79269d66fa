#pragma once

#include "accel/binary_tree.h"
#include "accel/binary_tree_builder.h"

namespace calotype {

/// A tree in which a random ray is expected to meet few boxes: each split is the one, of 31 planes
/// along each axis (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies") or,
/// of 8 primitives or fewer, of all, with the least sum of half area times count. Where no plane
/// parts the centres, and far down a lopsided tree, it splits by the median. Deterministic.
BinaryTree buildSahSplit(std::span<const Primitive> primitives, const BuildOptions& options = {});

} // namespace calotype
