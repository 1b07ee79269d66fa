#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace calotype {

/// Sixteen lower-case digits.
inline std::string hexadecimal(uint64_t value) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value));
    return digits;
}

} // namespace calotype
