#pragma once

#include <cmath>
#include <vector>

#include <glm/vec3.hpp>

namespace calotype::test {

/// Mean of some numbers, and the standard error of that mean.
struct Estimate {
    double mean = 0.0;
    double standardError = 0.0;
};

inline Estimate estimate(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    const double mean = sum / n;
    double squares = 0.0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (n * (n - 1.0)))};
}

} // namespace calotype::test
