#pragma once

#include <cstdint>
#include <vector>

#include "math/bounds.h"

namespace calotype {

/// Half the surface area; float is accurate enough to compare costs.
inline float halfAreaOf(const Bounds3f& bounds) {
    const glm::vec3 e = bounds.extent();
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// A binary tree of boxes with one primitive in each leaf: builders make it, and collapse converts
/// it to a wide BVH. Nodes are in depth-first order. A tree over n primitives has 2 n - 1 nodes, so
/// the place of each node is known before it is made, on any thread.
struct BinaryTree {
    struct Node {
        Bounds3f bounds;
        uint32_t first = 0; ///< index into `order` of the primitives below
        uint32_t count = 0; ///< number of these primitives

        bool isLeaf() const { return count == 1; }
    };
    std::vector<Node> nodes;     ///< empty for an empty scene
    std::vector<uint32_t> order; ///< numbers of the primitives, leaf after leaf

    static uint32_t leftOf(uint32_t node) { return node + 1; }
    uint32_t rightOf(uint32_t node) const { return node + 2 * nodes[node + 1].count; }
};

} // namespace calotype
