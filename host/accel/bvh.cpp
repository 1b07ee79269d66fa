#include "accel/bvh.h"

#include <algorithm>

#include "shared/limits.h"

namespace calotype {
namespace {

/// Calls visit(node index, depth) for each node, parents first, until it returns false. A node may
/// be visited at most once per edge that leads to it, and never more often than there are nodes.
template <typename Visit>
void forEachNode(const Bvh& bvh, const Visit& visit) {
    std::vector<std::pair<uint32_t, uint32_t>> stack;
    if (!bvh.nodes.empty())
        stack.emplace_back(0, 0);
    while (!stack.empty()) {
        const auto [index, depth] = stack.back();
        stack.pop_back();
        if (!visit(index, depth))
            return;
        const Bvh::Node& node = bvh.nodes[index];
        if (!node.isLeaf()) {
            stack.emplace_back(node.first + 1, depth + 1);
            stack.emplace_back(node.first, depth + 1);
        }
    }
}

std::string nodeName(uint32_t index) { return "node " + std::to_string(index); }

std::optional<std::string> findLeafDefect(const Bvh& bvh, const Bvh::Node& leaf,
                                          std::span<const Primitive> primitives,
                                          std::vector<bool>& seen) {
    if (leaf.count > gpu::kMaxLeafPrimitives)
        return "holds too many primitives";
    if (leaf.first > bvh.order.size() || leaf.count > bvh.order.size() - leaf.first)
        return "reaches beyond the primitives";
    for (uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
        const uint32_t number = bvh.order[i];
        if (number >= primitives.size())
            return "names a primitive that does not exist";
        if (seen[number])
            return "holds a primitive that another leaf holds";
        seen[number] = true;
        if (!leaf.bounds.contains(primitives[number].bounds))
            return "has a box that does not contain its primitives";
        if (primitives[number].kind != primitives[bvh.order[leaf.first]].kind)
            return "mixes kinds of primitives";
    }
    return std::nullopt;
}

} // namespace

BvhStatistics bvhStatistics(const Bvh& bvh) {
    BvhStatistics statistics;
    statistics.nodes = bvh.nodes.size();
    if (bvh.nodes.empty())
        return statistics;
    double cost = 0.0;
    forEachNode(bvh, [&](uint32_t index, uint32_t depth) {
        const Bvh::Node& node = bvh.nodes[index];
        const double tests = node.isLeaf() ? node.count : 2.0;
        cost += tests * halfArea(node.bounds);
        statistics.leaves += node.isLeaf() ? 1 : 0;
        statistics.depth = std::max(statistics.depth, depth);
        return true;
    });
    const Bvh::Node& root = bvh.nodes.front();
    const double rootArea = halfArea(root.bounds);
    statistics.sahCost = rootArea > 0.0 ? cost / rootArea : 0.0;
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
    std::optional<std::string> defect;
    std::vector<bool> reached(bvh.nodes.size(), false);
    std::vector<bool> seen(primitives.size(), false);
    forEachNode(bvh, [&](uint32_t index, uint32_t depth) {
        const Bvh::Node& node = bvh.nodes[index];
        if (reached[index])
            defect = nodeName(index) + " has two parents";
        else if (depth > gpu::kMaxBvhDepth)
            defect = nodeName(index) + " lies too deep";
        else if (node.isLeaf()) {
            if (const auto leafDefect = findLeafDefect(bvh, node, primitives, seen))
                defect = nodeName(index) + " " + *leafDefect;
        } else if (node.first == 0 || size_t{node.first} + 1 >= bvh.nodes.size())
            defect = nodeName(index) + " names children that do not exist";
        else if (!node.bounds.contains(bvh.nodes[node.first].bounds) ||
                 !node.bounds.contains(bvh.nodes[node.first + 1].bounds))
            defect = nodeName(index) + " does not contain its children";
        reached[index] = true;
        return !defect;
    });
    if (!defect && std::find(reached.begin(), reached.end(), false) != reached.end())
        defect = "a node cannot be reached from the root";
    if (!defect && std::find(seen.begin(), seen.end(), false) != seen.end())
        defect = "a primitive is in no leaf";
    return defect;
}

} // namespace calotype
