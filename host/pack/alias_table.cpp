#include "pack/alias_table.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace calotype {
namespace {

constexpr uint64_t kNumbers = uint64_t{1} << 24; ///< that a uniform random number may be

/// The random numbers that fall into each of `count` columns.
std::vector<uint32_t> columnCapacities(uint64_t count) {
    const auto numbersBefore = [&](uint64_t column) {
        return (column * kNumbers + count - 1) / count;
    };
    std::vector<uint32_t> capacities;
    for (uint64_t column = 0; column < count; ++column)
        capacities.push_back(
            static_cast<uint32_t>(numbersBefore(column + 1) - numbersBefore(column)));
    return capacities;
}

/// All random numbers, dealt out by weight: one each to all that weigh something, of the others
/// each one's share, rounded down, and what is left goes round in order.
std::vector<uint32_t> dealNumbers(std::span<const double> weights) {
    const auto weighsSomething = [](double weight) { return weight > 0.0; };
    const auto count = static_cast<uint64_t>(std::ranges::count_if(weights, weighsSomething));
    std::vector<uint32_t> dealt(weights.size());
    if (count == 0)
        return dealt;
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto shared = static_cast<double>(kNumbers - std::min(count, kNumbers));
    uint64_t left = kNumbers;
    for (size_t i = 0; i < weights.size(); ++i) {
        CALOTYPE_CHECK_LE(0.0, weights[i]);
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
    const std::vector<uint32_t> capacities = columnCapacities(weights.size());
    std::vector<uint32_t> numbers = dealNumbers(weights);
    std::vector<AliasColumn> columns(weights.size());
    std::vector<uint32_t> underfull;
    std::vector<uint32_t> overfull;
    for (uint32_t i = 0; i < weights.size(); ++i) {
        columns[i] = {numbers[i] * kProbabilityPerNumber, capacities[i], i};
        if (numbers[i] < capacities[i])
            underfull.push_back(i);
        else if (numbers[i] > capacities[i])
            overfull.push_back(i);
    }
    // Capacities differ by one at most, so that an overfull column can fill any underfull one.
    while (!underfull.empty() && !overfull.empty()) {
        const uint32_t receiver = underfull.back();
        const uint32_t donor = overfull.back();
        underfull.pop_back();
        columns[receiver].ownNumbers = numbers[receiver];
        columns[receiver].alias = donor;
        numbers[donor] -= capacities[receiver] - numbers[receiver];
        if (numbers[donor] > capacities[donor])
            continue;
        overfull.pop_back();
        if (numbers[donor] < capacities[donor])
            underfull.push_back(donor);
    }
    return columns;
}

} // namespace calotype
