#pragma once

#include "accel/binary_tree_builder.h"
#include "accel/bvh.h"
#include "settings/bvh_builder.h"

namespace calotype {

/// The builder that gives the picture of `paths` paths soonest.
BvhBuilder quickestBuilder(size_t primitives, uint64_t paths);

/// Splits, then joins to nodes of up to eight children, no deeper than kMaxBvhDepth. Deterministic,
/// whatever the threads.
Bvh buildBvh(std::span<const Primitive> primitives, BvhBuilder builder = BvhBuilder::Sah,
             const BuildOptions& options = {});

} // namespace calotype
