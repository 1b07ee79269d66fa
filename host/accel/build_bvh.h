#pragma once

#include "accel/binary_tree_builder.h"
#include "accel/bvh.h"
#include "settings/bvh_builder.h"

namespace calotype {

/// The builder with which a picture of `paths` paths takes the least time.
BvhBuilder quickestBuilder(size_t primitives, uint64_t paths);

/// Builds a binary tree, then collapses it to nodes of up to eight children, no deeper than
/// kMaxBvhDepth. Deterministic for any number of threads.
Bvh buildBvh(std::span<const Primitive> primitives, BvhBuilder builder = BvhBuilder::Sah,
             const BuildOptions& options = {});

} // namespace calotype
