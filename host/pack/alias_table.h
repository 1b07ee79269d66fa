#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace calotype {

/// One column of the table, and the random numbers that fall into it.
struct AliasColumn {
    double probability = 0.0; ///< of choosing the column's index, through any column
    uint32_t firstNumber = 0;
    uint32_t ownNumbers = 0;   ///< the first of these numbers, which choose the column's index
    uint32_t aliasNumbers = 0; ///< the numbers after those, which choose `alias`
    uint32_t alias = 0;
};

/// Builds a table that chooses an index in proportion to its weight, in constant time (Walker 1974,
/// built as in Vose 1991), by one of the 2^24 random numbers u = 0, 2^-24, ..: u belongs to column
/// floor(n u) of n. All counts are in such numbers, so that the probabilities are exact: multiples
/// of 2^-24 near the shares of the weights, at least one for every weight above 0. Weights are
/// finite and not negative; a weight of 0 is never chosen, and if all are 0, none is. If more than
/// 2^24 weights are above 0, those beyond are never chosen.
std::vector<AliasColumn> buildAliasTable(std::span<const double> weights);

} // namespace calotype
