#pragma once

#include <cstdint>
#include <vector>

#include "accel/bvh.h"

namespace calotype {

/// The places of a tree's nodes in the packed array. The root is at 0.
struct NodePlaces {
    std::vector<uint32_t> ofNode;
    std::vector<uint32_t> baseOfChildren; ///< by parent: a child lies at this + its slot
    uint32_t end = 0;                     ///< one beyond the last place
};

/// Finds places such that the place of a child follows from its parent and its slot alone. Siblings
/// fill gaps between other siblings (the double array of Aoe 1989, "An Efficient Digital Search
/// Algorithm"), so that few places stay empty.
NodePlaces placeNodes(const Bvh& bvh);

} // namespace calotype
