#include "base/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace calotype {
namespace {

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

} // namespace

std::string withPrefix(double number) {
    const char* prefixes[] = {"", " k", " M", " G", " T"};
    size_t prefix = 0;
    for (; number >= 999.5 && prefix + 1 < std::size(prefixes); ++prefix)
        number /= 1000.0;
    return formatted(number < 9.995   ? "%.2f"
                     : number < 99.95 ? "%.1f"
                                      : "%.0f",
                     number) +
           prefixes[prefix];
}

std::string shortNumber(double number, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

std::string percentText(double share) {
    const double percent = 100.0 * share;
    return formatted(0.0 < percent && percent < 0.01 ? "%.1g %%"
                     : percent < 9.995               ? "%.2f %%"
                     : percent < 99.95               ? "%.1f %%"
                                                     : "%.0f %%",
                     percent);
}

std::string targetText(double share) { return shortNumber(100.0 * share) + " %"; }

std::string durationText(double seconds) {
    if (seconds < 9.95)
        return formatted("%.1f s", seconds);
    const auto whole = static_cast<long>(std::lround(std::min(seconds, 1e9)));
    if (whole < 60)
        return std::to_string(whole) + " s";
    char text[64];
    if (whole < 3600)
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60,
                      whole % 60);
    return text;
}

} // namespace calotype
