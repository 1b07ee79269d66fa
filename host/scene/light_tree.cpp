#include "scene/light_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

#include "base/check.h"
#include "math/greatest.h"

namespace calotype {
namespace {

constexpr size_t kMostLightBins = 12;

/// The measure of directions to which a cone of normals shines: the integral over the sphere of the
/// greatest cosine with one of the normals (section 4.3 of the paper, for lights that shine to a
/// hemisphere).
double measureOfDirections(double thetaO) {
    constexpr double kHalfTurn = std::numbers::pi;
    if (thetaO >= kHalfTurn)
        return 4.0 * kHalfTurn;
    const double thetaW = std::min(thetaO + 0.5 * kHalfTurn, kHalfTurn);
    const double sinO = std::sin(thetaO);
    const double cosO = std::cos(thetaO);
    return 2.0 * kHalfTurn * (1.0 - cosO) +
           0.5 * kHalfTurn *
               (2.0 * thetaW * sinO - std::cos(thetaO - 2.0 * thetaW) - 2.0 * thetaO * sinO + cosO);
}

/// The squared diagonal stands for the area, because lights may be on a line.
double costOf(const LightCluster& cluster) {
    const glm::dvec3 extent = cluster.bounds.extent();
    return cluster.power * measureOfDirections(cluster.thetaO) * glm::dot(extent, extent);
}

/// The lights of consecutive bins.
struct LightBin {
    std::optional<LightCluster> cluster;

    void add(const LightCluster& other) { cluster = cluster ? joined(*cluster, other) : other; }
    void add(const LightBin& other) {
        if (other.cluster)
            add(*other.cluster);
    }
};

/// Bins of equal width between the least and the greatest centre along an axis.
struct LightBinning {
    int axis = 0;
    size_t count = 0;
    double lower = 0.0;
    double extent = 0.0;

    size_t binOf(const LightCluster& light) const {
        const double place = (light.center()[axis] - lower) / extent;
        return std::min(static_cast<size_t>(place * static_cast<double>(count)), count - 1);
    }
};

/// A plane between two bins.
struct LightSplit {
    LightBinning binning;
    size_t binsBefore = 0;
    double cost = std::numeric_limits<double>::infinity();
};

class LightTreeBuilder {
public:
    explicit LightTreeBuilder(std::span<const LightCluster> lights) : lights_(lights) {
        order_.resize(lights.size());
        std::iota(order_.begin(), order_.end(), 0u);
        tree_.trails.resize(lights.size());
    }

    LightTree build() {
        if (lights_.size() >= 2)
            add(order_, 0, 0);
        return std::move(tree_);
    }

private:
    using Range = std::span<uint32_t>;

    /// Adds a node, or the only light, and returns it.
    LightTree::Child add(Range range, uint32_t trail, uint32_t depth) {
        if (range.size() == 1) {
            tree_.trails[range[0]] = trail;
            tree_.depth = std::max(tree_.depth, depth);
            return {lights_[range[0]], range[0], true};
        }
        CALOTYPE_CHECK_LT(depth, LightTree::kMostDepth);
        const auto index = static_cast<uint32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        const size_t middle = split(range, LightTree::kMostDepth - depth - 1);
        const LightTree::Child first = add(range.first(middle), trail, depth + 1);
        const LightTree::Child second =
            add(range.subspan(middle), trail | uint32_t{1} << depth, depth + 1);
        tree_.nodes[index] = {{first, second}};
        return {joined(first.cluster, second.cluster), index, false};
    }

    /// Divides the range into two parts and returns the size of the first. Each part must fit into
    /// a tree of `levelsLeft` levels: where a part might not, the parts are halves.
    size_t split(Range range, uint32_t levelsLeft) const {
        const auto levelsOfHalves = static_cast<uint32_t>(std::bit_width(range.size() - 1));
        const LightSplit best = levelsOfHalves <= levelsLeft ? cheapestSplit(range) : LightSplit{};
        if (best.binsBefore == 0)
            return halve(range);
        const auto second = std::stable_partition(range.begin(), range.end(), [&](uint32_t light) {
            return best.binning.binOf(lights_[light]) < best.binsBefore;
        });
        return static_cast<size_t>(second - range.begin());
    }

    Bounds3d boundsOfCenters(Range range) const {
        Bounds3d centers;
        for (const uint32_t light : range)
            centers.extend(lights_[light].center());
        return centers;
    }

    /// By count, along the longest axis.
    size_t halve(Range range) const {
        const glm::dvec3 extent = boundsOfCenters(range).extent();
        const int axis = extent.x >= greatest(extent) ? 0 : extent.y >= extent.z ? 1 : 2;
        std::stable_sort(range.begin(), range.end(), [&](uint32_t a, uint32_t b) {
            return lights_[a].center()[axis] < lights_[b].center()[axis];
        });
        return range.size() / 2;
    }

    LightSplit cheapestSplit(Range range) const {
        const Bounds3d centers = boundsOfCenters(range);
        const double longest = greatest(centers.extent());
        LightSplit best;
        for (int axis = 0; axis < 3; ++axis) {
            const LightBinning binning{axis, std::min(range.size(), kMostLightBins),
                                       centers.lower[axis], centers.extent()[axis]};
            if (binning.extent > 0.0)
                improve(range, binning, longest / binning.extent, best);
        }
        return best;
    }

    /// `thinness` is how much longer the longest axis is: the paper's factor against thin clusters.
    void improve(Range range, const LightBinning& binning, double thinness,
                 LightSplit& best) const {
        std::array<LightBin, kMostLightBins> bins;
        for (const uint32_t light : range)
            bins[binning.binOf(lights_[light])].add(lights_[light]);
        std::array<double, kMostLightBins> costAfter{};
        LightBin after;
        for (size_t i = binning.count - 1; i > 0; --i) {
            after.add(bins[i]);
            costAfter[i] = after.cluster ? costOf(*after.cluster) : 0.0;
        }
        LightBin before;
        for (size_t i = 1; i < binning.count; ++i) {
            before.add(bins[i - 1]);
            const double cost =
                thinness * ((before.cluster ? costOf(*before.cluster) : 0.0) + costAfter[i]);
            if (cost < best.cost)
                best = {binning, i, cost};
        }
    }

    std::span<const LightCluster> lights_;
    std::vector<uint32_t> order_;
    LightTree tree_;
};

} // namespace

LightTree buildLightTree(std::span<const LightCluster> lights) {
    return LightTreeBuilder(lights).build();
}

} // namespace calotype
