#include "accel/median_split.h"

#include <algorithm>

namespace calotype {
namespace {

int widestAxis(std::span<const BoxReference> references) {
    Bounds3f centers;
    for (const BoxReference& reference : references)
        centers.extend(reference.doubledCenter());
    const glm::vec3 extent = centers.extent();
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

} // namespace

size_t splitByMedian(std::span<BoxReference> references) {
    const int axis = widestAxis(references);
    const auto middle = references.begin() + static_cast<ptrdiff_t>(references.size() / 2);
    std::nth_element(references.begin(), middle, references.end(),
                     [axis](const BoxReference& a, const BoxReference& b) {
                         const float centerA = a.lower[axis] + a.upper[axis];
                         const float centerB = b.lower[axis] + b.upper[axis];
                         return centerA < centerB || (centerA == centerB && a.number < b.number);
                     });
    return references.size() / 2;
}

BinaryTree buildMedianSplit(std::span<const Primitive> primitives, const BuildOptions& options) {
    const auto split = [](std::span<BoxReference> references, uint32_t, uint32_t) {
        return splitByMedian(references);
    };
    return BinaryTreeBuilder(primitives, options, split).build();
}

} // namespace calotype
