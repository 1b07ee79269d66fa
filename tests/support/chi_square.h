#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace calotype::test {

/// Pearson's statistic of counts against the same number of samples spread as `chances` (sum 1).
/// Meaningful where every expected count is above about 10.
inline double chiSquare(std::span<const uint64_t> counts, std::span<const double> chances) {
    uint64_t samples = 0;
    for (const uint64_t count : counts)
        samples += count;
    double sum = 0.0;
    for (size_t i = 0; i < counts.size(); ++i) {
        const double expected = chances[i] * static_cast<double>(samples);
        const double difference = static_cast<double>(counts[i]) - expected;
        sum += difference * difference / expected;
    }
    return sum;
}

/// What a chi-square variable stays below but for once in 30,000 times: Wilson and Hilferty's
/// approximation at four standard deviations.
inline double chiSquareLimit(size_t degreesOfFreedom) {
    const auto n = static_cast<double>(degreesOfFreedom);
    const double root = 1.0 - 2.0 / (9.0 * n) + 4.0 * std::sqrt(2.0 / (9.0 * n));
    return n * root * root * root;
}

} // namespace calotype::test
