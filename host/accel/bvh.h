#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accel/primitive.h"
#include "math/bounds.h"

namespace calotype {

/// A bounding volume hierarchy whose nodes have up to eight children. Node 0 is the root. Children
/// that are nodes are consecutive from `firstNode` on; the primitives of children that are leaves
/// are consecutive from `firstPrimitive` on; both in the order of the slots.
struct Bvh {
    static constexpr uint32_t kSlots = 8;
    static constexpr uint32_t kMostInLeaf = 3;

    enum class SlotKind : uint8_t { Empty, Node, Triangles, Quadrics };

    /// A child: a node, or a leaf of primitives of one kind.
    struct Slot {
        Bounds3f bounds;
        SlotKind kind = SlotKind::Empty;
        uint8_t count = 0; ///< number of primitives of a leaf

        bool isLeaf() const { return count > 0; }
    };

    /// The slot of a child encodes its position: bits 2, 1 and 0 are set if it is farther along x,
    /// y and z than its siblings, as far as they can be ordered so.
    struct Node {
        Bounds3f bounds;
        uint32_t firstNode = 0;
        uint32_t firstPrimitive = 0; ///< index into `order`
        std::array<Slot, kSlots> slots;
    };
    std::vector<Node> nodes;     ///< empty for an empty scene
    std::vector<uint32_t> order; ///< numbers of the primitives, leaf after leaf
    uint32_t depth = 0;          ///< edges from the root to the deepest node
};

struct BvhStatistics {
    size_t nodes = 0;
    size_t leaves = 0;
    double childrenPerNode = 0.0;
    double primitivesPerLeaf = 0.0;
    /// Expected number of nodes and primitives that a random line visits if it hits the root's box
    /// (Goldsmith and Salmon 1987).
    double nodesVisited = 0.0;
    double primitivesVisited = 0.0;
    double quadricsVisited = 0.0; ///< those primitives that are quadrics
};

BvhStatistics bvhStatistics(const Bvh& bvh);

/// The first defect of the structure, as a sentence; nothing if it is valid: each primitive is in
/// exactly one leaf, each box contains its contents, leaves have one kind of primitives and at most
/// kMostInLeaf, each node is reached exactly once, and the depth is correct.
std::optional<std::string> findBvhDefect(const Bvh& bvh, std::span<const Primitive> primitives);

} // namespace calotype
