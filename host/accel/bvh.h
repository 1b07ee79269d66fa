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
/// that are nodes follow each other from `firstNode` on, and the primitives of those that are
/// leaves from `firstPrimitive` on, both in the order of the slots.
struct Bvh {
    static constexpr uint32_t kSlots = 8;
    static constexpr uint32_t kMostInLeaf = 3;

    enum class SlotKind : uint8_t { Empty, Node, Triangles, Quadrics };

    /// A child: a node, or a leaf of primitives of one kind.
    struct Slot {
        Bounds3f bounds;
        SlotKind kind = SlotKind::Empty;
        uint8_t count = 0; ///< primitives of a leaf

        bool isLeaf() const { return count > 0; }
    };

    /// The place of a child among the slots says where it lies: bits 2, 1 and 0 are set where it is
    /// farther along x, y and z than its siblings, as well as they can be told apart.
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
    /// Expected nodes and primitives that a random line visits which meets the root's box
    /// (Goldsmith and Salmon 1987).
    double nodesVisited = 0.0;
    double primitivesVisited = 0.0;
    double quadricsVisited = 0.0; ///< of the primitives
};

BvhStatistics bvhStatistics(const Bvh& bvh);

/// What is wrong with the structure, as a sentence; nothing if all is well: each primitive in
/// exactly one leaf, each box containing its contents, leaves of one kind and of at most
/// kMostInLeaf, no node unreachable or reached twice, and the depth as it says.
std::optional<std::string> findBvhDefect(const Bvh& bvh, std::span<const Primitive> primitives);

} // namespace calotype
