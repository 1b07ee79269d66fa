#include "accel/collapse_choices.h"

#include <algorithm>

#include "accel/collapse.h"
#include "base/fork_join.h"

namespace calotype {

CollapseChoices::CollapseChoices(const BinaryTree& tree, std::span<const Primitive> primitives,
                                 uint32_t threads)
    : tree_(tree), primitives_(primitives), threads_(threads),
      isMixed_(std::ranges::any_of(primitives, [&](const Primitive& primitive) {
          return primitive.kind != primitives.front().kind;
      })) {
    choices_.resize(tree.nodes.size() / 2);
    if (!tree.nodes.empty())
        choose(0, 0);
}

/// True for few primitives of one kind.
bool CollapseChoices::canBeLeaf(uint32_t node) const {
    const BinaryTree::Node& binary = tree_.nodes[node];
    if (binary.count > Bvh::kMostInLeaf)
        return false;
    const auto kindOf = [&](uint32_t i) { return primitives_[tree_.order[i]].kind; };
    for (uint32_t i = binary.first + 1; isMixed_ && i < binary.first + binary.count; ++i)
        if (kindOf(i) != kindOf(binary.first))
            return false;
    return true;
}

float CollapseChoices::costOfLeaf(uint32_t node) const {
    return halfAreaOf(tree_.nodes[node].bounds) * static_cast<float>(tree_.nodes[node].count);
}

/// The cheapest distribution of `roots` children to the left and the right side.
CollapseChoices::Distribution CollapseChoices::distribute(const Costs& left, const Costs& right,
                                                          uint32_t roots) {
    Distribution best;
    for (uint8_t ofLeft = 1; ofLeft < roots; ++ofLeft) {
        const float sum = left[ofLeft - 1] + right[roots - ofLeft - 1];
        if (sum < best.cost)
            best = {sum, ofLeft};
    }
    return best;
}

CollapseChoices::Costs CollapseChoices::choose(uint32_t node, uint32_t depth) {
    const BinaryTree::Node& binary = tree_.nodes[node];
    Costs costs;
    if (binary.isLeaf()) {
        costs.fill(costOfLeaf(node));
        return costs;
    }
    Costs left;
    Costs right;
    forkJoin(
        isWorthForking(binary.count, depth, threads_),
        [&] { left = choose(BinaryTree::leftOf(node), depth + 1); },
        [&] { right = choose(tree_.rightOf(node), depth + 1); });
    Choice& choice = at(node);
    const Distribution asNode = distribute(left, right, Bvh::kSlots);
    choice.ofLeft.back() = asNode.ofLeft;
    costs[0] = asNode.cost + kNodeCost * halfAreaOf(binary.bounds);
    choice.isLeaf = canBeLeaf(node) && costOfLeaf(node) <= costs[0];
    if (choice.isLeaf)
        costs[0] = costOfLeaf(node);
    for (uint32_t roots = 2; roots <= kMostRoots; ++roots) {
        const Distribution asForest = distribute(left, right, roots);
        const bool needsAll = asForest.cost < costs[roots - 2];
        costs[roots - 1] = needsAll ? asForest.cost : costs[roots - 2];
        choice.ofLeft[roots - 2] = needsAll ? asForest.ofLeft : 0;
    }
    return costs;
}

} // namespace calotype
