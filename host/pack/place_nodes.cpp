#include "pack/place_nodes.h"

#include <algorithm>

namespace calotype {
namespace {

/// The slots that hold nodes, one bit each.
uint64_t nodeSlots(const Bvh::Node& node) {
    uint64_t bits = 0;
    for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot)
        bits |= uint64_t{node.slots[slot].kind == Bvh::SlotKind::Node} << slot;
    return bits;
}

/// A window of 64 places, where children are placed. Places before the window are used or stay
/// empty.
class Window {
public:
    /// Returns the base of the first free places that fit the bits of the slots.
    uint32_t take(uint64_t slots) {
        uint32_t offset = 0;
        while ((slots << offset & taken_) != 0)
            ++offset;
        taken_ |= slots << offset;
        const uint32_t base = begin_ + offset;
        // Moves the window so that the next children always fit into it.
        constexpr uint32_t kMostAhead = 64 - 2 * Bvh::kSlots;
        for (; (taken_ & 1) != 0 || taken_ >> kMostAhead != 0; taken_ >>= 1)
            ++begin_;
        return base;
    }

private:
    uint32_t begin_ = 0;
    uint64_t taken_ = 0; ///< bit i: the place begin_ + i
};

} // namespace

NodePlaces placeNodes(const Bvh& bvh) {
    NodePlaces places{std::vector<uint32_t>(bvh.nodes.size()),
                      std::vector<uint32_t>(bvh.nodes.size()), 0};
    Window window;
    if (!bvh.nodes.empty())
        places.end = window.take(1) + 1;
    for (size_t i = 0; i < bvh.nodes.size(); ++i) {
        const uint64_t slots = nodeSlots(bvh.nodes[i]);
        if (slots == 0)
            continue;
        const uint32_t base = window.take(slots);
        places.baseOfChildren[i] = base;
        uint32_t child = bvh.nodes[i].firstNode;
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
            if ((slots >> slot & 1) == 0)
                continue;
            places.ofNode[child++] = base + slot;
            places.end = std::max(places.end, base + slot + 1);
        }
    }
    return places;
}

} // namespace calotype
