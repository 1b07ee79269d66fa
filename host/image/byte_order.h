#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace calotype {

/// Unsigned numbers in the bytes of a file. The number at `at` must lie within `bytes`.
inline uint32_t byteAt(std::string_view bytes, size_t at) {
    return static_cast<unsigned char>(bytes[at]);
}

inline uint32_t littleEndian16(std::string_view bytes, size_t at) {
    return byteAt(bytes, at) | byteAt(bytes, at + 1) << 8;
}

inline uint32_t littleEndian32(std::string_view bytes, size_t at) {
    return littleEndian16(bytes, at) | littleEndian16(bytes, at + 2) << 16;
}

inline uint32_t bigEndian32(std::string_view bytes, size_t at) {
    return byteAt(bytes, at) << 24 | byteAt(bytes, at + 1) << 16 | byteAt(bytes, at + 2) << 8 |
           byteAt(bytes, at + 3);
}

} // namespace calotype
