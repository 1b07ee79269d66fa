#pragma once

#include "accel/binary_tree.h"
#include "accel/binary_tree_builder.h"

namespace calotype {

/// Puts the half of the references with the lower centres first, along the axis in which the
/// centres lie farthest apart; equal centres go by number. Returns how many they are.
size_t splitByMedian(std::span<BoxReference> references);

/// The tree that `--bvh median` selects: primitives are split into two halves of equal count by the
/// centres of their boxes along one axis. Deterministic.
BinaryTree buildMedianSplit(std::span<const Primitive> primitives,
                            const BuildOptions& options = {});

} // namespace calotype
