#include "accel/collapse.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/collapse_choices.h"
#include "base/parallel_for.h"

namespace calotype {
namespace {

constexpr uint32_t kNoChild = ~0u;

/// Children of a wide node, as nodes of the binary tree.
struct Children {
    std::array<uint32_t, Bvh::kSlots> nodes;
    uint32_t count = 0;

    void add(uint32_t node) { nodes[count++] = node; }
};

/// Assigns each child to a slot, beginning with the child farthest from the middle of the node.
/// Each takes the free slot along whose direction it is farthest from the middle.
std::array<uint32_t, Bvh::kSlots> childOfSlot(const BinaryTree& tree, const Bounds3f& bounds,
                                              const Children& children) {
    struct FreeChild {
        glm::vec3 offset{0.0f};
        float farthest = -1.0f; ///< distance along the direction of its best slot
        uint32_t node = kNoChild;
    };
    const glm::vec3 middle = bounds.lower + bounds.upper;
    std::array<FreeChild, Bvh::kSlots> waiting;
    for (uint32_t i = 0; i < children.count; ++i) {
        const Bounds3f& box = tree.nodes[children.nodes[i]].bounds;
        const glm::vec3 offset = box.lower + box.upper - middle;
        waiting[i] = {offset, std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z),
                      children.nodes[i]};
    }
    std::array<uint32_t, Bvh::kSlots> childOf;
    childOf.fill(kNoChild);
    for (uint32_t i = 0; i < children.count; ++i) {
        FreeChild& next = *std::ranges::max_element(waiting, {}, &FreeChild::farthest);
        float farthestInSlot = -std::numeric_limits<float>::infinity();
        uint32_t bestSlot = 0;
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
            const float distance = (slot & 4 ? next.offset.x : -next.offset.x) +
                                   (slot & 2 ? next.offset.y : -next.offset.y) +
                                   (slot & 1 ? next.offset.z : -next.offset.z);
            if (childOf[slot] == kNoChild && distance > farthestInSlot) {
                farthestInSlot = distance;
                bestSlot = slot;
            }
        }
        childOf[bestSlot] = next.node;
        next.farthest = -1.0f; // less than any distance
    }
    return childOf;
}

/// Makes the wide nodes, one depth after the other.
class Collapser {
public:
    Collapser(const BinaryTree& tree, std::span<const Primitive> primitives, uint32_t threads)
        : tree_(tree), primitives_(primitives), threads_(threads),
          choices_(tree, primitives, threads) {}

    Bvh collapse() {
        if (tree_.nodes.empty())
            return {};
        bvh_.order.resize(tree_.order.size());
        bvh_.nodes.reserve(tree_.order.size() / 8 + 1); // about one node for ten primitives
        std::vector<uint32_t> level = {0};
        while (!level.empty()) {
            level = addLevel(level);
            bvh_.depth += level.empty() ? 0 : 1;
        }
        return std::move(bvh_);
    }

private:
    /// Adds a wide node for each of the given binary nodes. Returns those of the next level.
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
        std::vector<uint32_t> next(nextNode - bvh_.nodes.size());
        parallelFor(0, level.size(), threads_, [&](uint64_t i, uint32_t) {
            const Bvh::Node& node = bvh_.nodes[begin + i];
            placeContents(node, childrenOf[i], next.data() + (node.firstNode - bvh_.nodes.size()));
        });
        return next;
    }

    std::array<uint32_t, Bvh::kSlots> fillSlots(Bvh::Node& node, uint32_t binary) const {
        Children children;
        if (choices_.isLeaf(binary)) // the root, if there are few primitives
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
            if (choices_.isLeaf(childOf[slot])) {
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

    /// Adds the best set of at most `roots` >= 2 subtrees below an inner node.
    void addRoots(uint32_t node, uint32_t roots, Children& children) const {
        const uint32_t ofLeft = choices_.rootsOfLeft(node, roots);
        addForest(BinaryTree::leftOf(node), ofLeft, children);
        addForest(tree_.rightOf(node), roots - ofLeft, children);
    }

    void addForest(uint32_t node, uint32_t roots, Children& children) const {
        if (!tree_.nodes[node].isLeaf()) {
            while (roots > 1 && choices_.rootsOfLeft(node, roots) == 0)
                --roots;
            if (roots > 1)
                return addRoots(node, roots, children);
        }
        children.add(node);
    }

    /// Sets the places of a node's primitives, and of its children from `next` on.
    void placeContents(const Bvh::Node& node, const std::array<uint32_t, Bvh::kSlots>& childOf,
                       uint32_t* next) {
        uint32_t place = node.firstPrimitive;
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
            if (node.slots[slot].kind == Bvh::SlotKind::Node)
                *next++ = childOf[slot];
            for (uint32_t i = 0; i < node.slots[slot].count; ++i)
                bvh_.order[place++] = tree_.order[tree_.nodes[childOf[slot]].first + i];
        }
    }

    const BinaryTree& tree_;
    std::span<const Primitive> primitives_;
    uint32_t threads_;
    CollapseChoices choices_;
    Bvh bvh_;
    uint32_t nextPrimitive_ = 0;
};

} // namespace

Bvh collapse(const BinaryTree& tree, std::span<const Primitive> primitives, uint32_t threads) {
    return Collapser(tree, primitives, threads).collapse();
}

} // namespace calotype
