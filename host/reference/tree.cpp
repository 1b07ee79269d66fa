#include "reference/tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace calotype::reference {
namespace {

/// Twice the centre of a box along an axis.
double center(const Bounds3d& box, int axis) { return box.lower[axis] + box.upper[axis]; }

int widestAxis(const glm::dvec3& extent) {
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

} // namespace

Tree::Tree(const std::vector<Bounds3d>& boxes) : order_(boxes.size()) {
    if (boxes.empty())
        return;
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(boxes.size());
    build(boxes, 0, static_cast<uint32_t>(boxes.size()), 0);
    const Bounds3d& all = nodes_.front().box;
    for (int axis = 0; axis < 3; ++axis)
        magnitude_ = std::max({magnitude_, std::abs(all.lower[axis]), std::abs(all.upper[axis])});
}

void Tree::build(const std::vector<Bounds3d>& boxes, uint32_t begin, uint32_t end, uint32_t depth) {
    const std::span<uint32_t> numbers(order_.data() + begin, end - begin);
    Node node;
    Bounds3d centers;
    for (const uint32_t number : numbers) {
        node.box.extend(boxes[number]);
        centers.extend(boxes[number].lower + boxes[number].upper);
    }
    const size_t index = nodes_.size();
    nodes_.push_back(node);
    if (numbers.size() <= kLeafSize) {
        nodes_[index].first = begin;
        nodes_[index].count = end - begin;
        return;
    }
    const int axis = widestAxis(centers.extent());
    const double middle = 0.5 * centers.lower[axis] + 0.5 * centers.upper[axis];
    auto upperHalf = std::ranges::partition(numbers, [&](uint32_t number) {
                         return center(boxes[number], axis) < middle;
                     }).begin();
    const bool isCut = upperHalf != numbers.begin() && upperHalf != numbers.end();
    if (!isCut || depth >= kDeepestMiddleCut) {
        upperHalf = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
        std::ranges::nth_element(numbers, upperHalf, {},
                                 [&](uint32_t number) { return center(boxes[number], axis); });
    }
    const uint32_t cut = begin + static_cast<uint32_t>(upperHalf - numbers.begin());
    build(boxes, begin, cut, depth + 1);
    nodes_[index].axis = axis;
    nodes_[index].first = static_cast<uint32_t>(nodes_.size());
    build(boxes, cut, end, depth + 1);
}

} // namespace calotype::reference
