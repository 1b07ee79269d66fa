#include "settings/value_text.h"

#include <utility>

#include "settings/limits.h"

namespace calotype {

std::optional<std::vector<uint32_t>> parseList(std::string_view text, char separator,
                                               size_t count) {
    std::vector<uint32_t> numbers;
    while (true) {
        const size_t end = text.find(separator);
        const auto number = parseNumber<uint32_t>(text.substr(0, end));
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        if (end == std::string_view::npos)
            break;
        text.remove_prefix(end + 1);
    }
    if (numbers.size() != count)
        return std::nullopt;
    return numbers;
}

std::optional<double> parseSeconds(std::string_view text) {
    constexpr std::pair<char, double> kUnits[] = {{'s', 1.0}, {'m', 60.0}, {'h', 3600.0}};
    double unit = 1.0;
    for (const auto& [letter, seconds] : kUnits)
        if (text.ends_with(letter)) {
            text.remove_suffix(1);
            unit = seconds;
            break;
        }
    const double seconds = parseNumber<double>(text).value_or(0.0) * unit;
    return seconds > 0.0 && seconds <= kMostSeconds ? std::optional(seconds) : std::nullopt;
}

} // namespace calotype
