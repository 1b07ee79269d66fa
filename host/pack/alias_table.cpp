#include "pack/alias_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.h"

namespace calotype {
namespace {

constexpr uint64_t kNumbers = uint64_t{1} << 24; ///< possible values of a uniform random number

/// The number of random numbers in the columns before `column`, of `count` columns.
uint32_t numbersBefore(uint64_t column, uint64_t count) {
    return static_cast<uint32_t>((column * kNumbers + count - 1) / count);
}

/// Distributes all random numbers by weight: one to each weight above 0, then to each its share of
/// the others, rounded down; the rest goes to the weights in turn.
std::vector<uint32_t> dealNumbers(std::span<const double> weights) {
    const auto weighsSomething = [](double weight) {
        CALOTYPE_CHECK_LE(0.0, weight);
        return weight > 0.0;
    };
    const auto count = static_cast<uint64_t>(std::ranges::count_if(weights, weighsSomething));
    std::vector<uint32_t> dealt(weights.size());
    if (count == 0)
        return dealt;
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    CALOTYPE_CHECK_EQ(std::isfinite(sum), true);
    const auto shared = static_cast<double>(kNumbers - std::min(count, kNumbers));
    uint64_t left = kNumbers;
    for (size_t i = 0; i < weights.size(); ++i) {
        dealt[i] = static_cast<uint32_t>(weights[i] / sum * shared);
        left -= dealt[i];
    }
    for (size_t i = 0; left > 0; i = (i + 1) % weights.size())
        if (weighsSomething(weights[i])) {
            ++dealt[i];
            --left;
        }
    return dealt;
}

} // namespace

std::vector<AliasColumn> buildAliasTable(std::span<const double> weights) {
    constexpr double kProbabilityPerNumber = 1.0 / kNumbers;
    std::vector<uint32_t> numbers = dealNumbers(weights);
    std::vector<AliasColumn> columns;
    std::vector<uint32_t> underfull;
    std::vector<uint32_t> overfull;
    for (uint32_t i = 0; i < weights.size(); ++i) {
        const uint32_t first = numbersBefore(i, weights.size());
        const uint32_t capacity = numbersBefore(i + 1, weights.size()) - first;
        columns.push_back({numbers[i] * kProbabilityPerNumber, first, capacity, 0, i});
        if (numbers[i] < capacity)
            underfull.push_back(i);
        else if (numbers[i] > capacity)
            overfull.push_back(i);
    }
    // Capacities differ by one at most, so that an overfull column can fill any underfull one.
    while (!underfull.empty() && !overfull.empty()) {
        const uint32_t receiver = underfull.back();
        const uint32_t donor = overfull.back();
        underfull.pop_back();
        AliasColumn& column = columns[receiver];
        column.aliasNumbers = column.ownNumbers - numbers[receiver];
        column.ownNumbers = numbers[receiver];
        column.alias = donor;
        numbers[donor] -= column.aliasNumbers;
        const uint32_t capacity = columns[donor].ownNumbers; // no number is an alias's yet
        if (numbers[donor] > capacity)
            continue;
        overfull.pop_back();
        if (numbers[donor] < capacity)
            underfull.push_back(donor);
    }
    return columns;
}

} // namespace calotype
