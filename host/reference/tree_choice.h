#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include <glm/vec3.hpp>

#include "scene/light_tree.h"

namespace calotype::reference {

/// A point to be lit. Light from below the plane of its normal is not scattered, if it has one.
struct LitPoint {
    glm::dvec3 position;
    std::optional<glm::dvec3> normal = {}; ///< unit
};

/// Chooses a light for a point by what the clusters of a light tree may contribute to it
/// (docs/models.md, "Light tree").
class TreeChoice {
public:
    TreeChoice() = default;
    explicit TreeChoice(LightTree tree) : tree_(std::move(tree)) {}

    /// True if there are fewer than two lights: then nothing can be chosen.
    bool empty() const { return tree_.nodes.empty(); }

    struct Chosen {
        uint32_t light;       ///< of those from which the tree was built
        double u;             ///< uniform in [0, 1), also given that this light was chosen
        double probability;   ///< above 0
        double withoutNormal; ///< the probability if the normal were not known
    };

    /// u in [0, 1).
    Chosen choose(const LitPoint& point, double u) const;

    /// With which `choose` chooses that light for a point without a normal.
    double probability(const glm::dvec3& position, uint32_t light) const;

private:
    LightTree tree_;
};

/// A bound of the light that a cluster sends to the point, up to a factor: importance without the
/// point's normal.
double emittedImportance(const LightCluster& cluster, const glm::dvec3& point);

/// A bound of the cosine with which the point receives the light of the cluster; 1 if it has no
/// normal.
double receivedShare(const LightCluster& cluster, const LitPoint& point);

} // namespace calotype::reference
