#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace calotype {

/// One column: keep its own index when a uniform number falls below `threshold`, else take `alias`.
struct AliasColumn {
    double chance = 0.0; ///< the index's probability: its weight over the sum
    double threshold = 1.0;
    uint32_t alias = 0;
};

/// Choosing an index in proportion to its weight, in constant time (Walker 1974, built as in Vose
/// 1991). The weights are finite, none negative. Where all are 0, so are the chances.
std::vector<AliasColumn> buildAliasTable(std::span<const double> weights);

} // namespace calotype
