#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.h"

namespace calotype::fuzz {

inline std::string_view textOf(const uint8_t* data, size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Runs `read`: to refuse with a sentence is as good as to succeed. Whatever else it throws ends
/// the fuzzer.
template <typename Read>
void readOrRefuse(Read&& read) {
    try {
        read();
    } catch (const Error&) {
        // one complete sentence to the user
    }
}

} // namespace calotype::fuzz
