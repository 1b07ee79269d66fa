#include "accel/median_split.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/check.h"
#include "shared/limits.h"

namespace calotype {
namespace {

class MedianSplitBuilder {
public:
    MedianSplitBuilder(std::span<const Primitive> primitives,
                       const std::function<void(double)>& onProgress)
        : primitives_(primitives), onProgress_(onProgress) {
        bvh_.order.resize(primitives.size());
        std::iota(bvh_.order.begin(), bvh_.order.end(), 0u);
    }

    Bvh build() {
        if (primitives_.empty())
            return {};
        bvh_.nodes.reserve(primitives_.size());
        bvh_.nodes.emplace_back();
        buildNode(0, 0, static_cast<uint32_t>(primitives_.size()), 0);
        return std::move(bvh_);
    }

private:
    using Iterator = std::vector<uint32_t>::iterator;

    /// Fills a node for the range [begin, end) of `order`, and all below it.
    void buildNode(uint32_t index, uint32_t begin, uint32_t end, uint32_t depth) {
        CALOTYPE_CHECK_LE(depth, gpu::kMaxBvhDepth);
        Bounds3f bounds;
        bool oneKind = true;
        const PrimitiveKind firstKind = primitives_[bvh_.order[begin]].kind;
        for (uint32_t i = begin; i < end; ++i) {
            const Primitive& primitive = primitives_[bvh_.order[i]];
            bounds.extend(primitive.bounds);
            oneKind = oneKind && primitive.kind == firstKind;
        }
        bvh_.nodes[index].bounds = bounds;
        const uint32_t count = end - begin;
        const bool small = count <= gpu::kMaxLeafPrimitives;
        if (small && oneKind) {
            bvh_.nodes[index].first = begin;
            bvh_.nodes[index].count = count;
            reportLeaf(end);
            return;
        }
        const uint32_t middle = small ? splitByKind(begin, end) : splitByMedian(begin, end);
        const auto left = static_cast<uint32_t>(bvh_.nodes.size());
        bvh_.nodes[index].first = left;
        bvh_.nodes.resize(left + 2);
        buildNode(left, begin, middle, depth + 1);
        buildNode(left + 1, middle, end, depth + 1);
    }

    uint32_t splitByKind(uint32_t begin, uint32_t end) {
        const Iterator order = bvh_.order.begin();
        const Iterator middle = std::stable_partition(order + begin, order + end, [&](uint32_t i) {
            return primitives_[i].kind == PrimitiveKind::Triangle;
        });
        return static_cast<uint32_t>(middle - order);
    }

    /// The axis along which the two halves get the smallest boxes: the surface area heuristic, for
    /// halves of equal count.
    uint32_t splitByMedian(uint32_t begin, uint32_t end) {
        int best = 0;
        double leastArea = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const uint32_t middle = partitionByMedian(begin, end, axis);
            const double area = halfArea(boundsOf(begin, middle)) + halfArea(boundsOf(middle, end));
            if (area < leastArea) {
                leastArea = area;
                best = axis;
            }
        }
        return partitionByMedian(begin, end, best);
    }

    uint32_t partitionByMedian(uint32_t begin, uint32_t end, int axis) {
        const uint32_t middle = begin + (end - begin) / 2;
        const Iterator order = bvh_.order.begin();
        std::nth_element(order + begin, order + middle, order + end, [&](uint32_t a, uint32_t b) {
            const float centerA = doubledCenter(primitives_[a])[axis];
            const float centerB = doubledCenter(primitives_[b])[axis];
            return centerA < centerB || (centerA == centerB && a < b);
        });
        return middle;
    }

    Bounds3f boundsOf(uint32_t begin, uint32_t end) const {
        Bounds3f bounds;
        for (uint32_t i = begin; i < end; ++i)
            bounds.extend(primitives_[bvh_.order[i]].bounds);
        return bounds;
    }

    static glm::vec3 doubledCenter(const Primitive& primitive) {
        return primitive.bounds.lower + primitive.bounds.upper;
    }

    void reportLeaf(uint32_t primitivesDone) {
        constexpr uint32_t kPrimitivesPerReport = 1 << 16;
        if (onProgress_ && primitivesDone / kPrimitivesPerReport != reported_) {
            reported_ = primitivesDone / kPrimitivesPerReport;
            onProgress_(static_cast<double>(primitivesDone) /
                        static_cast<double>(primitives_.size()));
        }
    }

    std::span<const Primitive> primitives_;
    const std::function<void(double)>& onProgress_;
    uint32_t reported_ = 0;
    Bvh bvh_;
};

} // namespace

Bvh buildMedianSplit(std::span<const Primitive> primitives,
                     const std::function<void(double)>& onProgress) {
    return MedianSplitBuilder(primitives, onProgress).build();
}

} // namespace calotype
