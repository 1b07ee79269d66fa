#pragma once

#include <cstdint>
#include <vector>

#include "accel/bvh.h"

namespace calotype {

/// Where the nodes of a tree lie in the packed array. The root lies at 0.
struct NodePlaces {
    std::vector<uint32_t> ofNode;
    std::vector<uint32_t> baseOfChildren; ///< by parent: a child lies at this + its slot
    uint32_t end = 0;                     ///< beyond the last place
};

/// Finds places such that a child's follows from its parent and its slot alone, whatever the
/// other slots hold. Families are fitted into each other's gaps (the double array of Aoe 1989, "An
/// Efficient Digital Search Algorithm"), so that few places stay empty.
NodePlaces placeNodes(const Bvh& bvh);

} // namespace calotype
