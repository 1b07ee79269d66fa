#include "accel/collapse.h"

#include <algorithm>
#include <limits>

#include "base/fork_join.h"
#include "base/parallel_for.h"

namespace calotype {
namespace {

constexpr uint32_t kMostRoots = Bvh::kSlots - 1;

/// The least cost of the primitives below a node of the binary tree, if they hang from at most
/// 1, 2, ... kMostRoots children of one wide node: C(n, i) of the paper.
using Costs = std::array<float, kMostRoots>;

/// The least cost by dynamic programming from the leaves up, and the choices that lead to it.
class CostTable {
public:
    CostTable(const BinaryTree& tree, std::span<const Primitive> primitives, uint32_t threads)
        : tree_(tree), primitives_(primitives), threads_(threads),
          isMixed_(std::ranges::any_of(primitives, [&](const Primitive& primitive) {
              return primitive.kind != primitives.front().kind;
          })) {
        rows_.resize(tree.nodes.size() / 2);
        if (!rows_.empty())
            fill(0, 0);
    }

    /// Whether the node, as one child, is better a leaf than a wide node.
    bool isLeaf(uint32_t node) const {
        return canBeLeaf(node) &&
               (tree_.nodes[node].isLeaf() || costOfLeaf(node) <= costOfNode(node));
    }

    /// How many of `roots` >= 2 children the left side of an inner node gets.
    uint32_t rootsOfLeft(uint32_t node, uint32_t roots) const {
        return distribute(node, roots).left;
    }

    /// Whether the primitives below the node had better hang from fewer than `roots` >= 2 children.
    bool needsFewer(uint32_t node, uint32_t roots) const {
        return cost(node, roots - 1) < distribute(node, roots).cost;
    }

private:
    struct Distribution {
        float cost = std::numeric_limits<float>::infinity();
        uint32_t left = 0;
    };

    float cost(uint32_t node, uint32_t roots) const {
        return tree_.nodes[node].isLeaf() ? costOfLeaf(node) : row(node)[roots - 1];
    }

    /// Few primitives, of one kind.
    bool canBeLeaf(uint32_t node) const {
        const BinaryTree::Node& binary = tree_.nodes[node];
        if (binary.count > Bvh::kMostInLeaf)
            return false;
        const auto kindOf = [&](uint32_t i) { return primitives_[tree_.order[i]].kind; };
        for (uint32_t i = binary.first + 1; isMixed_ && i < binary.first + binary.count; ++i)
            if (kindOf(i) != kindOf(binary.first))
                return false;
        return true;
    }

    /// Inner nodes have a row each: all nodes before this one but the leaves among them.
    const Costs& row(uint32_t node) const { return rows_[node - tree_.nodes[node].first]; }
    Costs& row(uint32_t node) { return rows_[node - tree_.nodes[node].first]; }

    float costOfLeaf(uint32_t node) const {
        return halfAreaOf(tree_.nodes[node].bounds) * static_cast<float>(tree_.nodes[node].count);
    }

    float costOfNode(uint32_t node) const {
        return distribute(node, Bvh::kSlots).cost +
               kNodeCost * halfAreaOf(tree_.nodes[node].bounds);
    }

    Distribution distribute(uint32_t node, uint32_t roots) const {
        const uint32_t left = BinaryTree::leftOf(node);
        const uint32_t right = tree_.rightOf(node);
        Distribution best;
        for (uint32_t ofLeft = 1; ofLeft < roots; ++ofLeft) {
            const float sum = cost(left, std::min(ofLeft, kMostRoots)) +
                              cost(right, std::min(roots - ofLeft, kMostRoots));
            if (sum < best.cost)
                best = {sum, ofLeft};
        }
        return best;
    }

    void fill(uint32_t node, uint32_t depth) {
        constexpr uint32_t kFewestPrimitives = 8192;
        const BinaryTree::Node& binary = tree_.nodes[node];
        if (binary.isLeaf())
            return;
        const bool forks = threads_ > 1 && binary.count >= kFewestPrimitives &&
                           (uint64_t{1} << depth) < uint64_t{8} * threads_;
        forkJoin(
            forks, [&] { fill(BinaryTree::leftOf(node), depth + 1); },
            [&] { fill(tree_.rightOf(node), depth + 1); });
        Costs& costs = row(node);
        const float leaf =
            canBeLeaf(node) ? costOfLeaf(node) : std::numeric_limits<float>::infinity();
        costs[0] = std::min(leaf, costOfNode(node));
        for (uint32_t roots = 2; roots <= kMostRoots; ++roots)
            costs[roots - 1] = std::min(costs[roots - 2], distribute(node, roots).cost);
    }

    const BinaryTree& tree_;
    std::span<const Primitive> primitives_;
    uint32_t threads_;
    bool isMixed_; ///< primitives are of more than one kind
    std::vector<Costs> rows_;
};

constexpr uint32_t kNoChild = ~0u;

/// Children of a wide node, as nodes of the binary tree.
struct Children {
    std::array<uint32_t, Bvh::kSlots> nodes;
    uint32_t count = 0;

    void add(uint32_t node) { nodes[count++] = node; }
};

/// Puts each child into a slot: pairs of child and slot in the order of how far the child lies in
/// the slot's direction from the middle of the node, greedily.
std::array<uint32_t, Bvh::kSlots> childOfSlot(const BinaryTree& tree, const Bounds3f& bounds,
                                              const Children& children) {
    std::array<uint32_t, Bvh::kSlots> childOf;
    childOf.fill(kNoChild);
    const glm::vec3 middle = bounds.lower + bounds.upper;
    std::array<std::array<float, Bvh::kSlots>, Bvh::kSlots> distances; // of child and slot
    for (uint32_t i = 0; i < children.count; ++i) {
        const Bounds3f& box = tree.nodes[children.nodes[i]].bounds;
        const glm::vec3 offset = box.lower + box.upper - middle;
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot)
            distances[i][slot] = (slot & 4 ? offset.x : -offset.x) +
                                 (slot & 2 ? offset.y : -offset.y) +
                                 (slot & 1 ? offset.z : -offset.z);
    }
    std::array<bool, Bvh::kSlots> isPlaced{};
    for (uint32_t placed = 0; placed < children.count; ++placed) {
        float farthest = -std::numeric_limits<float>::infinity();
        uint32_t bestChild = 0;
        uint32_t bestSlot = 0;
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
            if (childOf[slot] != kNoChild)
                continue;
            for (uint32_t i = 0; i < children.count; ++i) {
                if (!isPlaced[i] && distances[i][slot] > farthest) {
                    farthest = distances[i][slot];
                    bestChild = i;
                    bestSlot = slot;
                }
            }
        }
        childOf[bestSlot] = children.nodes[bestChild];
        isPlaced[bestChild] = true;
    }
    return childOf;
}

/// Makes the wide nodes of one depth after the other.
class Collapser {
public:
    Collapser(const BinaryTree& tree, std::span<const Primitive> primitives, uint32_t threads)
        : tree_(tree), primitives_(primitives), threads_(threads),
          costs_(tree, primitives, threads) {}

    Bvh collapse() {
        if (tree_.nodes.empty())
            return {};
        bvh_.order.resize(tree_.order.size());
        std::vector<uint32_t> level = {0};
        while (!level.empty()) {
            level = addLevel(level);
            bvh_.depth += level.empty() ? 0 : 1;
        }
        return std::move(bvh_);
    }

private:
    /// Adds a wide node for each of the given ones; returns those of the next level.
    std::vector<uint32_t> addLevel(const std::vector<uint32_t>& level) {
        const size_t begin = bvh_.nodes.size();
        bvh_.nodes.resize(begin + level.size());
        std::vector<std::array<uint32_t, Bvh::kSlots>> childrenOf(level.size());
        parallelFor(0, level.size(), threads_, [&](uint64_t i, uint32_t) {
            childrenOf[i] = fillSlots(bvh_.nodes[begin + i], level[i]);
        });
        auto nextNode = static_cast<uint32_t>(bvh_.nodes.size());
        for (size_t i = begin; i < bvh_.nodes.size(); ++i) {
            Bvh::Node& node = bvh_.nodes[i];
            node.firstNode = nextNode;
            node.firstPrimitive = nextPrimitive_;
            for (const Bvh::Slot& slot : node.slots) {
                nextNode += slot.kind == Bvh::SlotKind::Node ? 1 : 0;
                nextPrimitive_ += slot.count;
            }
        }
        std::vector<uint32_t> next;
        next.reserve(nextNode - bvh_.nodes.size());
        for (size_t i = 0; i < level.size(); ++i)
            placeContents(bvh_.nodes[begin + i], childrenOf[i], next);
        return next;
    }

    std::array<uint32_t, Bvh::kSlots> fillSlots(Bvh::Node& node, uint32_t binary) const {
        Children children;
        if (costs_.isLeaf(binary)) // of few primitives, the root
            children.add(binary);
        else
            addRoots(binary, Bvh::kSlots, children);
        node.bounds = tree_.nodes[binary].bounds;
        const auto childOf = childOfSlot(tree_, node.bounds, children);
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
            if (childOf[slot] == kNoChild)
                continue;
            const BinaryTree::Node& child = tree_.nodes[childOf[slot]];
            node.slots[slot] = {child.bounds};
            if (costs_.isLeaf(childOf[slot])) {
                node.slots[slot].kind = kindOfLeaf(child);
                node.slots[slot].count = static_cast<uint8_t>(child.count);
            } else {
                node.slots[slot].kind = Bvh::SlotKind::Node;
            }
        }
        return childOf;
    }

    Bvh::SlotKind kindOfLeaf(const BinaryTree::Node& node) const {
        return primitives_[tree_.order[node.first]].kind == PrimitiveKind::Triangle
                   ? Bvh::SlotKind::Triangles
                   : Bvh::SlotKind::Quadrics;
    }

    /// Adds the best forest of at most `roots` >= 2 trees for what is below an inner node.
    void addRoots(uint32_t node, uint32_t roots, Children& children) const {
        const uint32_t ofLeft = costs_.rootsOfLeft(node, roots);
        addForest(BinaryTree::leftOf(node), ofLeft, children);
        addForest(tree_.rightOf(node), roots - ofLeft, children);
    }

    void addForest(uint32_t node, uint32_t roots, Children& children) const {
        if (!tree_.nodes[node].isLeaf()) {
            while (roots > 1 && costs_.needsFewer(node, roots))
                --roots;
            if (roots > 1)
                return addRoots(node, roots, children);
        }
        children.add(node);
    }

    void placeContents(const Bvh::Node& node, const std::array<uint32_t, Bvh::kSlots>& childOf,
                       std::vector<uint32_t>& next) {
        uint32_t place = node.firstPrimitive;
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
            if (node.slots[slot].kind == Bvh::SlotKind::Node)
                next.push_back(childOf[slot]);
            for (uint32_t i = 0; i < node.slots[slot].count; ++i)
                bvh_.order[place++] = tree_.order[tree_.nodes[childOf[slot]].first + i];
        }
    }

    const BinaryTree& tree_;
    std::span<const Primitive> primitives_;
    uint32_t threads_;
    CostTable costs_;
    Bvh bvh_;
    uint32_t nextPrimitive_ = 0;
};

} // namespace

Bvh collapse(const BinaryTree& tree, std::span<const Primitive> primitives, uint32_t threads) {
    return Collapser(tree, primitives, threads).collapse();
}

} // namespace calotype
