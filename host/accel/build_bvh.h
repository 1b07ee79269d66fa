#pragma once

#include "accel/binary_tree_builder.h"
#include "accel/bvh.h"

namespace calotype {

enum class BvhBuilder : uint8_t {
    Median, ///< the report's: halves of equal count; quick to build
    Sah,    ///< by the surface area heuristic; quick to traverse
};

/// "median" or "sah", as --bvh takes it.
constexpr const char* nameOf(BvhBuilder builder) {
    return builder == BvhBuilder::Median ? "median" : "sah";
}

/// The builder that gives the picture of `paths` paths soonest.
BvhBuilder quickestBuilder(size_t primitives, uint64_t paths);

/// Splits, then joins to nodes of up to eight children, no deeper than kMaxBvhDepth. Deterministic,
/// whatever the threads.
Bvh buildBvh(std::span<const Primitive> primitives, BvhBuilder builder = BvhBuilder::Sah,
             const BuildOptions& options = {});

} // namespace calotype
