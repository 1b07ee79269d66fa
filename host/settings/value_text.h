#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace calotype {

/// The number in `text`, or nothing unless the whole text is one.
template <typename T>
std::optional<T> parseNumber(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// Whole numbers between separators, or nothing unless there are exactly `count`.
std::optional<std::vector<uint32_t>> parseList(std::string_view text, char separator, size_t count);

/// Seconds in "30s", "1.5m", "2h" or a bare number of seconds; nothing unless above 0 and at most
/// kMostSeconds.
std::optional<double> parseSeconds(std::string_view text);

} // namespace calotype
