#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace calotype {

/// ASCII letters in lower case; other characters stay.
inline std::string lowercase(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
}

} // namespace calotype
