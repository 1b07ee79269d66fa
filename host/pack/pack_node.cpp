#include "pack/pack_node.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace calotype {
namespace {

constexpr int kMostCells = 255;

/// Whether origin + cells * size is above `place`, in exact arithmetic.
bool isAbove(double origin, double cellsTimesSize, double place) {
    // The sum's rounding error is a double (Knuth's two-sum); cells * size has 32 bits at most.
    const double sum = origin + cellsTimesSize;
    const double ofSecond = sum - origin;
    const double error = (origin - (sum - ofSecond)) + (cellsTimesSize - ofSecond);
    return sum > place || (sum == place && error > 0.0);
}

/// One axis of the grid: cells whose size is a power of two.
class Grid {
public:
    Grid(double lower, double upper) : origin_(lower) {
        exponent_ = std::max(kLeastExponent, std::ilogb(std::max(upper - lower, kLeastSize)) - 8);
        size_ = std::ldexp(1.0, exponent_);
        for (; isAboveGrid(upper); size_ *= 2.0)
            ++exponent_;
    }

    /// The exponent in the form in which a float stores it.
    uint32_t biasedExponent() const { return static_cast<uint32_t>(exponent_ + 127); }

    /// The last cell boundary that is not above `place`.
    uint32_t cellsBelow(double place) const {
        auto cells =
            static_cast<int>(std::clamp((place - origin_) / size_, 0.0, double{kMostCells}));
        // The rounded quotient may be on either side of a boundary.
        while (cells > 0 && isAbove(origin_, cells * size_, place))
            --cells;
        while (cells < kMostCells && !isAbove(origin_, (cells + 1) * size_, place))
            ++cells;
        return static_cast<uint32_t>(cells);
    }

    /// The first cell boundary that is not below `place`.
    uint32_t cellsAbove(double place) const {
        uint32_t cells = cellsBelow(place);
        while (isBelow(cells, place))
            ++cells;
        return cells;
    }

private:
    static constexpr int kLeastExponent = -126; ///< of a normal float
    static constexpr double kLeastSize = 0x1p-118;

    bool isBelow(uint32_t cells, double place) const {
        return isAbove(-origin_, -static_cast<double>(cells) * size_, -place);
    }

    bool isAboveGrid(double place) const { return isBelow(kMostCells, place); }

    double origin_;
    int exponent_;
    double size_; ///< of a cell: 2^exponent_
};

uint32_t bitOf(uint32_t slot, bool isSet) { return isSet ? 1u << slot : 0u; }

} // namespace

shared::BvhNode packNode(const Bvh::Node& node, const FirstPrimitives& first, uint32_t childBase) {
    // Where the node is, and where its children are.
    shared::BvhNode packed{};
    packed.origin = node.bounds.lower;
    packed.childBase = childBase;
    packed.firstTriangle = first.triangle;
    packed.firstQuadric = first.quadric;
    // What each child is: a bit each for nodes and quadrics, three for the number of primitives.
    for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
        const Bvh::Slot& child = node.slots[slot];
        packed.nodesAndExponents |= bitOf(slot, child.kind == Bvh::SlotKind::Node) << 24;
        packed.primitives |= bitOf(slot, child.kind == Bvh::SlotKind::Quadrics) << 24;
        packed.primitives |= ((1u << child.count) - 1u) << (3 * slot);
    }
    // The children's boxes, axis by axis: cells of the grid, rounded outward, a byte a child.
    shared::uvec2* const lower[] = {&packed.lowerX, &packed.lowerY, &packed.lowerZ};
    shared::uvec2* const upper[] = {&packed.upperX, &packed.upperY, &packed.upperZ};
    for (int axis = 0; axis < 3; ++axis) {
        const Grid grid(node.bounds.lower[axis], node.bounds.upper[axis]);
        packed.nodesAndExponents |= grid.biasedExponent() << (8 * axis);
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
            const Bvh::Slot& child = node.slots[slot];
            if (child.kind == Bvh::SlotKind::Empty)
                continue;
            const uint32_t shift = 8 * (slot % 4);
            (*lower[axis])[slot / 4] |= grid.cellsBelow(child.bounds.lower[axis]) << shift;
            (*upper[axis])[slot / 4] |= grid.cellsAbove(child.bounds.upper[axis]) << shift;
        }
    }
    return packed;
}

} // namespace calotype
