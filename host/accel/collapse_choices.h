#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "accel/binary_tree.h"
#include "accel/bvh.h"

namespace calotype {

/// The best way to join the nodes of a binary tree, by dynamic programming from the leaves up
/// (Ylitie, Karras and Laine 2017, section 3.2).
class CollapseChoices {
public:
    CollapseChoices(const BinaryTree& tree, std::span<const Primitive> primitives,
                    uint32_t threads);

    /// Whether the node is a leaf (not a node) as a single child of a wide node.
    bool isLeaf(uint32_t node) const { return tree_.nodes[node].isLeaf() || at(node).isLeaf; }

    /// If the node becomes `roots` >= 2 children of one wide node: the number of children from the
    /// left side, or 0 if one child fewer is as good.
    uint32_t rootsOfLeft(uint32_t node, uint32_t roots) const { return at(node).ofLeft[roots - 2]; }

private:
    static constexpr uint32_t kMostRoots = Bvh::kSlots - 1;

    struct Choice {
        bool isLeaf = false;
        std::array<uint8_t, kMostRoots> ofLeft{}; ///< for 2, 3, ... kSlots roots
    };

    /// The least cost of the primitives below a node as at most 1, 2, ... kMostRoots children of
    /// one wide node: C(n, i) of the paper.
    using Costs = std::array<float, kMostRoots>;

    struct Distribution {
        float cost = std::numeric_limits<float>::infinity();
        uint8_t ofLeft = 0;
    };

    /// Only inner nodes have one: the index is the number of inner nodes before this one.
    const Choice& at(uint32_t node) const { return choices_[node - tree_.nodes[node].first]; }
    Choice& at(uint32_t node) { return choices_[node - tree_.nodes[node].first]; }

    static Distribution distribute(const Costs& left, const Costs& right, uint32_t roots);
    bool canBeLeaf(uint32_t node) const;
    float costOfLeaf(uint32_t node) const;
    Costs choose(uint32_t node, uint32_t depth);

    const BinaryTree& tree_;
    std::span<const Primitive> primitives_;
    uint32_t threads_;
    bool isMixed_; ///< there is more than one kind of primitives
    std::vector<Choice> choices_;
};

} // namespace calotype
