#include "pack/alias_table.h"

#include <cmath>
#include <numeric>

#include "base/check.h"

namespace calotype {
namespace {

constexpr uint64_t kNumbers = uint64_t{1} << 24; ///< that a uniform random number may be

/// The random numbers that fall into columns before `column`, of `count` columns.
uint64_t numbersBefore(uint64_t column, uint64_t count) {
    return (column * kNumbers + count - 1) / count;
}

void setProbabilities(std::vector<AliasColumn>& columns) {
    constexpr double kProbabilityPerNumber = 1.0 / kNumbers;
    for (uint64_t i = 0; i < columns.size(); ++i) {
        const uint64_t numbers =
            numbersBefore(i + 1, columns.size()) - numbersBefore(i, columns.size());
        const double probability = static_cast<double>(numbers) * kProbabilityPerNumber;
        columns[i].probability += probability * columns[i].threshold;
        columns[columns[i].alias].probability += probability * (1.0 - columns[i].threshold);
    }
}

/// The least multiple of 2^-24 that lets as many random numbers through.
double roundedUp(double threshold) { return std::ceil(threshold * kNumbers) / kNumbers; }

} // namespace

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
        columns[i].alias = i;
        const double share = sum > 0.0 ? weights[i] / sum : 0.0;
        filled[i] = share * static_cast<double>(weights.size());
        (filled[i] < 1.0 ? underfull : overfull).push_back(i);
    }
    while (!underfull.empty() && !overfull.empty()) {
        const uint32_t receiver = underfull.back();
        const uint32_t donor = overfull.back();
        underfull.pop_back();
        columns[receiver].threshold = roundedUp(filled[receiver]);
        columns[receiver].alias = donor;
        filled[donor] -= 1.0 - filled[receiver];
        if (filled[donor] < 1.0) {
            overfull.pop_back();
            underfull.push_back(donor);
        }
    }
    setProbabilities(
        columns); // of those left over, each is full but for rounding, or none has weight
    return columns;
}

} // namespace calotype
