#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace calotype {

/// One column: keep its own index when a uniform number falls below `threshold`, else take `alias`.
struct AliasColumn {
    double probability = 0.0; ///< with which the index is chosen
    double threshold = 1.0;   ///< a multiple of 2^-24
    uint32_t alias = 0;
};

/// Choosing an index in proportion to its weight, in constant time (Walker 1974, built as in Vose
/// 1991), by two random numbers that are multiples of 2^-24: column floor(n u) of n, then u within
/// it. The chances are what those numbers make of the columns, to the last one of them: near the
/// share of the weight, but never a share so small that no number could choose it so rarely.
/// The weights are finite, none negative; one of 0 has no chance, unless all are 0.
std::vector<AliasColumn> buildAliasTable(std::span<const double> weights);

} // namespace calotype
