#include "accel/sah_split.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "accel/median_split.h"

namespace calotype {
namespace {

constexpr size_t kBins = 32;
constexpr size_t kMostToSweep = 8;
/// Below this depth only halves of equal count: bounds the depth by 48 + log2(primitives).
constexpr uint32_t kDeepestSahSplit = 48;

struct Bin {
    Bounds3f bounds;
    uint32_t count = 0;

    void add(const Bin& other) {
        bounds.extend(other.bounds);
        count += other.count;
    }
    float cost() const { return count > 0 ? halfAreaOf(bounds) * static_cast<float>(count) : 0.0f; }
};

/// Metres. A smaller extent of centres is not binned, because the scale would overflow.
constexpr float kLeastExtent = 1e-30f;

/// The bin of a box: its doubled centre relative to the least and the greatest of all.
struct Binning {
    explicit Binning(const Bounds3f& centers) : lower(centers.lower) {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centers.upper[axis] - centers.lower[axis];
            // Slightly below the number of bins, so that the greatest centre is in the last.
            scale[axis] = extent > kLeastExtent ? kBins * (1.0f - 0x1p-20f) / extent : 0.0f;
        }
    }

    uint32_t binOf(const BoxReference& reference, int axis) const {
        const float center = reference.lower[axis] + reference.upper[axis];
        return static_cast<uint32_t>((center - lower[axis]) * scale[axis]);
    }

    glm::vec3 lower;
    glm::vec3 scale; ///< bins per metre of doubled centres; 0 if all are in the first
};

struct Plane {
    int axis = 0;
    uint32_t bins = 0; ///< on its left
};

/// The cheapest plane between bins along one axis, if it is cheaper than `leastCost`.
void improve(const std::array<Bin, kBins>& bins, int axis, std::optional<Plane>& best,
             float& leastCost) {
    std::array<float, kBins> costOfRight;
    Bin right;
    for (size_t i = kBins - 1; i > 0; --i) {
        right.add(bins[i]);
        costOfRight[i] = right.count > 0 ? right.cost() : std::numeric_limits<float>::infinity();
    }
    Bin left;
    for (uint32_t i = 1; i < kBins; ++i) {
        left.add(bins[i - 1]);
        const float cost = left.cost() + costOfRight[i];
        if (left.count > 0 && cost < leastCost) {
            leastCost = cost;
            best = Plane{axis, i};
        }
    }
}

/// A sum over all references, in parts on several threads: `add(sum, reference)`.
template <typename Sum, typename Add>
Sum sumUp(std::span<const BoxReference> references, uint32_t threads, Add&& add) {
    constexpr size_t kFewestForThreads = 1 << 16; // a millisecond of work
    Sum sum;
    if (threads == 1 || references.size() < kFewestForThreads) {
        for (const BoxReference& reference : references)
            add(sum, reference);
        return sum;
    }
    std::vector<Sum> sums(threads);
    parallelFor(0, threads, threads, [&](uint64_t part, uint32_t) {
        const size_t first = references.size() * part / threads;
        const size_t last = references.size() * (part + 1) / threads;
        for (const BoxReference& reference : references.subspan(first, last - first))
            add(sums[part], reference);
    });
    for (const Sum& ofPart : sums)
        sum.add(ofPart);
    return sum;
}

struct CenterBounds {
    Bounds3f bounds;

    void add(const CenterBounds& other) { bounds.extend(other.bounds); }
};

struct Bins {
    std::array<std::array<Bin, kBins>, 3> ofAxis;

    void add(const Bins& other) {
        for (int axis = 0; axis < 3; ++axis)
            for (size_t i = 0; i < kBins; ++i)
                ofAxis[axis][i].add(other.ofAxis[axis][i]);
    }
};

/// Partitions by the cheapest plane. Returns 0 if all centres are in one bin.
size_t splitByBins(std::span<BoxReference> references, uint32_t threads) {
    const auto centers = sumUp<CenterBounds>(references, threads,
                                             [](CenterBounds& sum, const BoxReference& reference) {
                                                 sum.bounds.extend(reference.doubledCenter());
                                             });
    const Binning binning(centers.bounds);
    const auto bins =
        sumUp<Bins>(references, threads, [&](Bins& sum, const BoxReference& reference) {
            for (int axis = 0; axis < 3; ++axis)
                sum.ofAxis[axis][binning.binOf(reference, axis)].add({reference.bounds(), 1});
        });
    std::optional<Plane> best;
    float leastCost = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        improve(bins.ofAxis[axis], axis, best, leastCost);
    if (!best)
        return 0;
    const auto middle =
        std::partition(references.begin(), references.end(), [&](const BoxReference& reference) {
            return binning.binOf(reference, best->axis) < best->bins;
        });
    return static_cast<size_t>(middle - references.begin());
}

void sortByCenter(std::span<BoxReference> references, int axis) {
    std::ranges::sort(references, [axis](const BoxReference& a, const BoxReference& b) {
        const float centerA = a.lower[axis] + a.upper[axis];
        const float centerB = b.lower[axis] + b.upper[axis];
        return centerA < centerB || (centerA == centerB && a.number < b.number);
    });
}

/// For few references: the cheapest split of their order along any axis.
size_t splitBySweep(std::span<BoxReference> references) {
    const size_t count = references.size();
    std::array<BoxReference, kMostToSweep> best;
    size_t bestLeft = count / 2;
    float leastCost = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        sortByCenter(references, axis);
        std::array<float, kMostToSweep> costOfRight{};
        Bin right;
        for (size_t i = count - 1; i > 0; --i) {
            right.add({references[i].bounds(), 1});
            costOfRight[i] = right.cost();
        }
        Bin left;
        bool isBest = axis == 0;
        for (size_t i = 1; i < count; ++i) {
            left.add({references[i - 1].bounds(), 1});
            const float cost = left.cost() + costOfRight[i];
            if (cost < leastCost) {
                leastCost = cost;
                bestLeft = i;
                isBest = true;
            }
        }
        if (isBest)
            std::ranges::copy(references, best.begin());
    }
    std::copy_n(best.begin(), count, references.begin());
    return leastCost > 0.0f ? bestLeft : count / 2; // boxes without area have no cost
}

size_t split(std::span<BoxReference> references, uint32_t depth, uint32_t threads) {
    if (references.size() == 2)
        return 1;
    if (depth > kDeepestSahSplit)
        return splitByMedian(references);
    if (references.size() <= kMostToSweep)
        return splitBySweep(references);
    const size_t left = splitByBins(references, threads);
    return left > 0 ? left : splitByMedian(references);
}

} // namespace

BinaryTree buildSahSplit(std::span<const Primitive> primitives, const BuildOptions& options) {
    return BinaryTreeBuilder(primitives, options, split).build();
}

} // namespace calotype
