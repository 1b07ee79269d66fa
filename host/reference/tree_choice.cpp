#include "reference/tree_choice.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace calotype::reference {
namespace {

/// The device adds it to cosines for its rounding errors.
constexpr double kCosineError = 1.0 / 512.0;

double radiusOf(const LightCluster& cluster) { return 0.5 * glm::length(cluster.bounds.extent()); }

double importanceOf(const LightCluster& cluster, const LitPoint& point) {
    return emittedImportance(cluster, point.position) * receivedShare(cluster, point);
}

/// The probability of the node's first child.
double shareOfFirst(const LightTree::Node& node, const LitPoint& point) {
    const double first = importanceOf(node.children[0].cluster, point);
    const double second = importanceOf(node.children[1].cluster, point);
    return first + second > 0.0 ? first / (first + second) : 0.5;
}

} // namespace

double emittedImportance(const LightCluster& cluster, const glm::dvec3& point) {
    const double radius = radiusOf(cluster);
    const glm::dvec3 d = point - cluster.center();
    const double distance = glm::length(d);
    if (distance <= radius)
        return cluster.power / (radius * radius);
    const double along = std::clamp(glm::dot(d, cluster.axis) / distance, -1.0, 1.0);
    const double theta = std::acos(cluster.isTwoSided ? std::abs(along) : along);
    const double outside = std::max(theta - cluster.thetaO, 0.0);
    const double share = std::cos(outside) + radius / distance + kCosineError;
    return cluster.power * std::clamp(share, 0.0, 1.0) / (distance * distance);
}

double receivedShare(const LightCluster& cluster, const LitPoint& point) {
    const double radius = radiusOf(cluster);
    const glm::dvec3 toLight = cluster.center() - point.position;
    const double distance = glm::length(toLight);
    if (!point.normal || distance <= radius)
        return 1.0;
    const double cosine = glm::dot(toLight, *point.normal) / distance;
    return std::clamp(cosine + radius / distance + kCosineError, 0.0, 1.0);
}

TreeChoice::Chosen TreeChoice::choose(const LitPoint& point, double u) const {
    double probability = 1.0;
    uint32_t node = 0;
    while (true) {
        const double share = shareOfFirst(tree_.nodes[node], point);
        const bool isFirst = u < share;
        u = isFirst ? u / share : (u - share) / (1.0 - share);
        probability *= isFirst ? share : 1.0 - share;
        const LightTree::Child& child = tree_.nodes[node].children[isFirst ? 0 : 1];
        if (child.isLight)
            return {child.index, u, probability, this->probability(point.position, child.index)};
        node = child.index;
    }
}

double TreeChoice::probability(const glm::dvec3& position, uint32_t light) const {
    double probability = 1.0;
    uint32_t node = 0;
    for (uint32_t trail = tree_.trails[light];; trail >>= 1) {
        const double share = shareOfFirst(tree_.nodes[node], {position});
        const bool isFirst = (trail & 1) == 0;
        probability *= isFirst ? share : 1.0 - share;
        const LightTree::Child& child = tree_.nodes[node].children[isFirst ? 0 : 1];
        if (child.isLight)
            return probability;
        node = child.index;
    }
}

} // namespace calotype::reference
