#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace calotype {

/// One column of the table, and the random numbers that fall into it.
struct AliasColumn {
    double probability = 0.0; ///< with which the column's index is chosen, by whatever column
    uint32_t firstNumber = 0;
    uint32_t ownNumbers = 0;   ///< from there on, which choose the column's index
    uint32_t aliasNumbers = 0; ///< after those, which choose `alias`
    uint32_t alias = 0;
};

/// Choosing an index in proportion to its weight, in constant time (Walker 1974, built as in Vose
/// 1991), by one of the 2^24 random numbers u = 0, 2^-24, ..: they fall into column floor(n u) of
/// n. All is counted in such numbers, so that the chances are exact: whole multiples of 2^-24 near
/// the shares of the weights, and one at least for the least of them. The weights are finite, none
/// negative; one of 0 has no chance, and if all are 0 none has. Where more than 2^24 weigh
/// something, those beyond have no chance.
std::vector<AliasColumn> buildAliasTable(std::span<const double> weights);

} // namespace calotype
