#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accel/primitive.h"
#include "math/bounds.h"

namespace calotype {

/// A binary bounding volume hierarchy, flattened: node 0 is the root, the children of a node are
/// neighbours, and every leaf holds primitives of one kind.
struct Bvh {
    struct Node {
        Bounds3f bounds;
        /// Leaf: index into `order`. Inner node: its left child; the right one is next to it.
        uint32_t first = 0;
        uint32_t count = 0; ///< primitives in a leaf; 0 for an inner node

        bool isLeaf() const { return count > 0; }
    };
    std::vector<Node> nodes;     ///< empty for an empty scene
    std::vector<uint32_t> order; ///< numbers of the primitives, leaf after leaf
};

struct BvhStatistics {
    size_t nodes = 0;
    size_t leaves = 0;
    uint32_t depth = 0; ///< edges from the root to the deepest leaf
    double primitivesPerLeaf = 0.0;
    /// Expected boxes and primitives tested by a random line that meets the root's box (Goldsmith
    /// and Salmon 1987), a box and a primitive counting 1 each.
    double sahCost = 0.0;
};

BvhStatistics bvhStatistics(const Bvh& bvh);

/// What is wrong with the structure, as a sentence; nothing if all is well: each primitive in
/// exactly one leaf, each box containing its contents, leaves of one kind and of at most
/// kMaxLeafPrimitives, no node unreachable or reached twice, depth within kMaxBvhDepth.
std::optional<std::string> findBvhDefect(const Bvh& bvh, std::span<const Primitive> primitives);

} // namespace calotype
