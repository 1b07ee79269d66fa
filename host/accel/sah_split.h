#pragma once

#include "accel/binary_tree.h"
#include "accel/binary_tree_builder.h"

namespace calotype {

/// A tree with a low expected number of boxes that a random ray hits. Each split has the least sum
/// of half area times count, among 31 planes along each axis (Wald 2007, "On fast Construction of
/// SAH-based Bounding Volume Hierarchies") or, for 8 primitives or fewer, among all planes. If no
/// plane separates the centres, or far below the root, it splits by the median. Deterministic.
BinaryTree buildSahSplit(std::span<const Primitive> primitives, const BuildOptions& options = {});

} // namespace calotype
