#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/bounds.h"
#include "reference/ray.h"
#include "reference/thick_ray.h"

namespace calotype::reference {

/// A tree of bounding boxes, split at the middle of the boxes' centres along their widest axis.
class Tree {
public:
    /// `boxes[n]` is the bounding box of primitive n.
    explicit Tree(const std::vector<Bounds3d>& boxes);

    /// Calls visit(number) for the primitives whose boxes the ray hits before t = `reach`, usually
    /// nearer ones first. `visit` may lower `reach`.
    template <typename Visit>
    void forEachAlong(const Ray& ray, const double& reach, Visit&& visit) const {
        if (nodes_.empty())
            return;
        const ThickRay thick(ray, magnitude_);
        std::array<uint32_t, kDeepest + 1> waiting; // the other child of each level above, at most
        waiting[0] = 0;
        for (size_t count = 1; count > 0;) {
            const uint32_t index = waiting[--count];
            const Node& node = nodes_[index];
            if (!thick.meets(node.box, reach))
                continue;
            if (node.count > 0) {
                for (uint32_t i = 0; i < node.count; ++i)
                    visit(order_[node.first + i]);
                continue;
            }
            const bool forward = ray.direction[node.axis] >= 0.0;
            const uint32_t lower = index + 1;
            const uint32_t upper = node.first;
            waiting[count++] = forward ? upper : lower;
            waiting[count++] = forward ? lower : upper;
        }
    }

private:
    /// Depth limit of splits at the middle. Below it, boxes are split into two halves of equal
    /// count, which takes less than 32 more levels.
    static constexpr uint32_t kDeepestMiddleCut = 64;
    static constexpr uint32_t kDeepest = kDeepestMiddleCut + 32;
    static constexpr uint32_t kLeafSize = 4;

    struct Node {
        Bounds3d box;
        uint32_t first = 0; ///< leaf: index into order_; else upper child; lower: next node
        uint32_t count = 0; ///< of a leaf's primitives; 0 for an inner node
        int axis = 0;       ///< along which an inner node is split
    };

    void build(const std::vector<Bounds3d>& boxes, uint32_t begin, uint32_t end, uint32_t depth);

    std::vector<Node> nodes_; ///< parents before their children; the first is the root
    std::vector<uint32_t> order_;
    double magnitude_ = 0.0; ///< largest coordinate
};

} // namespace calotype::reference
