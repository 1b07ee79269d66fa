#pragma once

#include "accel/binary_tree.h"
#include "accel/binary_tree_builder.h"

namespace calotype {

/// Moves the half of the references with the lower centres to the front, along the axis with the
/// largest extent of centres; equal centres are ordered by number. Returns the size of that half.
size_t splitByMedian(std::span<BoxReference> references);

/// The tree of `--bvh median`: primitives are split into two halves of equal count by the centres
/// of their boxes along one axis. Deterministic.
BinaryTree buildMedianSplit(std::span<const Primitive> primitives,
                            const BuildOptions& options = {});

} // namespace calotype
