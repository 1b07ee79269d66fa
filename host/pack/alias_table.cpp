#include "pack/alias_table.h"

#include <numeric>

#include "base/check.h"

namespace calotype {

std::vector<AliasColumn> buildAliasTable(std::span<const double> weights) {
    std::vector<AliasColumn> columns(weights.size());
    if (weights.empty())
        return columns;
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    CALOTYPE_CHECK_LE(0.0, sum);

    std::vector<double> filled(weights.size()); // in units of one column
    std::vector<uint32_t> underfull;
    std::vector<uint32_t> overfull;
    for (uint32_t i = 0; i < weights.size(); ++i) {
        columns[i].chance = sum > 0.0 ? weights[i] / sum : 0.0;
        columns[i].alias = i;
        filled[i] = columns[i].chance * static_cast<double>(weights.size());
        (filled[i] < 1.0 ? underfull : overfull).push_back(i);
    }
    while (!underfull.empty() && !overfull.empty()) {
        const uint32_t receiver = underfull.back();
        const uint32_t donor = overfull.back();
        underfull.pop_back();
        columns[receiver].threshold = filled[receiver];
        columns[receiver].alias = donor;
        filled[donor] -= 1.0 - filled[receiver];
        if (filled[donor] < 1.0) {
            overfull.pop_back();
            underfull.push_back(donor);
        }
    }
    return columns; // what is left over is full but for rounding, or all have no weight
}

} // namespace calotype
