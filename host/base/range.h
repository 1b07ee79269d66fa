#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace calotype {

/// The finite numbers between two ends. An end belongs to the range unless it is open.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool isLowOpen = false;
    bool isHighOpen = false;

    /// False for infinities and NaN.
    bool contains(double number) const {
        return std::isfinite(number) && (isLowOpen ? number > low : number >= low) &&
               (isHighOpen ? number < high : number <= high);
    }
};

constexpr Range closedRange(double low, double high) { return {low, high}; }
constexpr Range openRange(double low, double high) { return {low, high, true, true}; }
constexpr Range atLeast(double low) { return {.low = low}; }
constexpr Range greaterThan(double low) { return {.low = low, .isLowOpen = true}; }

/// The words after "must be": "in [0, 1]", "0 or greater", "greater than 0", "between 0 and 180,
/// both excluded", "greater than 0 and at most 5", "a finite number".
std::string toText(const Range& range);

} // namespace calotype
