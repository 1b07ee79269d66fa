#include "accel/bvh.h"

#include <algorithm>

namespace calotype {
namespace {

bool isOf(const Primitive& primitive, Bvh::SlotKind kind) {
    return (primitive.kind == PrimitiveKind::Triangle) == (kind == Bvh::SlotKind::Triangles);
}

/// Traverses the tree from its root and records what it finds.
class DefectFinder {
public:
    DefectFinder(const Bvh& bvh, std::span<const Primitive> primitives)
        : bvh_(bvh), primitives_(primitives), reached_(bvh.nodes.size(), false),
          seen_(primitives.size(), false) {}

    std::optional<std::string> find() {
        uint32_t depth = 0;
        for (std::vector<uint32_t> level = {0}; !level.empty(); ++depth) {
            std::vector<uint32_t> next;
            for (const uint32_t index : level)
                if (const auto defect = visit(index, next))
                    return "node " + std::to_string(index) + " " + *defect;
            level = std::move(next);
        }
        if (depth != bvh_.depth + 1)
            return "the depth is not that of the deepest node";
        if (std::ranges::find(reached_, false) != reached_.end())
            return "a node cannot be reached from the root";
        if (std::ranges::find(seen_, false) != seen_.end())
            return "a primitive is in no leaf";
        return std::nullopt;
    }

private:
    std::optional<std::string> visit(uint32_t index, std::vector<uint32_t>& next) {
        if (index >= bvh_.nodes.size())
            return "does not exist";
        if (reached_[index])
            return "has two parents";
        reached_[index] = true;
        const Bvh::Node& node = bvh_.nodes[index];
        uint32_t child = node.firstNode;
        size_t place = node.firstPrimitive;
        for (const Bvh::Slot& slot : node.slots) {
            if (slot.kind == Bvh::SlotKind::Empty)
                continue;
            if (!node.bounds.contains(slot.bounds))
                return "does not contain its children";
            if (slot.kind == Bvh::SlotKind::Node) {
                if (child < bvh_.nodes.size() && !slot.bounds.contains(bvh_.nodes[child].bounds))
                    return "has a slot that does not contain its node";
                next.push_back(child++);
            } else if (const auto defect = visitLeaf(slot, place)) {
                return defect;
            }
            place += slot.count;
        }
        return std::nullopt;
    }

    std::optional<std::string> visitLeaf(const Bvh::Slot& leaf, size_t place) {
        if (leaf.count == 0 || leaf.count > Bvh::kMostInLeaf)
            return "has a leaf of too few or too many primitives";
        if (place + leaf.count > bvh_.order.size())
            return "reaches beyond the primitives";
        for (size_t i = place; i < place + leaf.count; ++i) {
            const uint32_t number = bvh_.order[i];
            if (number >= primitives_.size())
                return "names a primitive that does not exist";
            if (seen_[number])
                return "holds a primitive that another leaf holds";
            seen_[number] = true;
            if (!leaf.bounds.contains(primitives_[number].bounds))
                return "has a leaf that does not contain its primitives";
            if (!isOf(primitives_[number], leaf.kind))
                return "has a leaf of mixed kinds";
        }
        return std::nullopt;
    }

    const Bvh& bvh_;
    std::span<const Primitive> primitives_;
    std::vector<bool> reached_;
    std::vector<bool> seen_;
};

} // namespace

BvhStatistics bvhStatistics(const Bvh& bvh) {
    BvhStatistics statistics;
    statistics.nodes = bvh.nodes.size();
    if (bvh.nodes.empty())
        return statistics;
    const double rootArea = halfArea(bvh.nodes.front().bounds);
    const auto share = [&](const Bounds3f& bounds) {
        return rootArea > 0.0 ? halfArea(bounds) / rootArea : 0.0;
    };
    size_t children = 0;
    for (const Bvh::Node& node : bvh.nodes) {
        statistics.nodesVisited += share(node.bounds);
        for (const Bvh::Slot& slot : node.slots) {
            children += slot.kind != Bvh::SlotKind::Empty ? 1 : 0;
            statistics.leaves += slot.isLeaf() ? 1 : 0;
            const double visited = slot.isLeaf() ? slot.count * share(slot.bounds) : 0.0;
            statistics.primitivesVisited += visited;
            statistics.quadricsVisited += slot.kind == Bvh::SlotKind::Quadrics ? visited : 0.0;
        }
    }
    statistics.childrenPerNode =
        static_cast<double>(children) / static_cast<double>(bvh.nodes.size());
    statistics.primitivesPerLeaf =
        static_cast<double>(bvh.order.size()) / static_cast<double>(statistics.leaves);
    return statistics;
}

std::optional<std::string> findBvhDefect(const Bvh& bvh, std::span<const Primitive> primitives) {
    if (bvh.order.size() != primitives.size())
        return "the tree does not hold as many primitives as the scene";
    if (primitives.empty())
        return bvh.nodes.empty() ? std::nullopt : std::optional("an empty scene has nodes");
    if (bvh.nodes.empty())
        return "the tree has no nodes";
    return DefectFinder(bvh, primitives).find();
}

} // namespace calotype
