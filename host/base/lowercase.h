#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace calotype {

/// With ASCII letters made small; all others must be written as they are.
inline std::string lowercase(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
}

} // namespace calotype
