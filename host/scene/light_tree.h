#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/light_cluster.h"

namespace calotype {

/// A binary tree over lights, to choose one by what it may contribute to a point (docs/models.md,
/// "Light tree").
struct LightTree {
    /// A node or, at the end of a branch, a light.
    struct Child {
        LightCluster cluster;
        uint32_t index = 0; ///< of the node, or of the light
        bool isLight = false;
    };
    struct Node {
        Child children[2];
    };
    static constexpr uint32_t kMostDepth = 32; ///< bits of a trail

    std::vector<Node> nodes; ///< the root is the first; none if there are fewer than two lights
    /// For each light, the way to it from the root: bit d says which child of the node at depth d.
    std::vector<uint32_t> trails;
    uint32_t depth = 0; ///< most nodes on the way from the root to a light
};

/// Splits by the surface area orientation heuristic (Conty Estevez and Kulla 2018, section 4.4) in
/// bins; takes n log n steps. The same lights give the same tree, and lights that are farther apart
/// by a power of two give a tree of the same form. Powers are above 0.
LightTree buildLightTree(std::span<const LightCluster> lights);

} // namespace calotype
