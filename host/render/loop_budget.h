#pragma once

#include <cstdint>
#include <optional>

#include "accel/bvh.h"
#include "gpu/device.h"

namespace calotype {

/// How many loop iterations a subgroup may take in one dispatch.
struct LoopBudget {
    uint32_t beforePause; ///< after which a pixel takes up no new sample
    uint32_t beforeCut;   ///< and after which a path is ended, and counted; or, where it was not
                          ///< the first of its pixel in the dispatch, begun again in the next one
};

LoopBudget loopBudget(const Device& device);

/// About how many scattering events a path may have on a device before it outgrows the budget, in a
/// scene of this tree; nothing where the device sets no limit. An estimate: a budget is shared by
/// the paths of a subgroup, and rays differ.
std::optional<uint32_t> bouncesBeforeCut(const Device& device, const BvhStatistics& bvh);

} // namespace calotype
