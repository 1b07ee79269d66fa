#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace calotype::fuzz {

/// Puts the right checksum at the end of each chunk of a PNG, as far as chunks can be recognised;
/// leaves other files as they are.
inline void repairPngChecksums(uint8_t* data, size_t size) {
    constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
    constexpr size_t kAround = 12; // length, type and checksum
    if (!std::string_view(reinterpret_cast<const char*>(data), size).starts_with(kSignature))
        return;
    size_t at = kSignature.size();
    while (size - at >= kAround) {
        const size_t length = size_t{data[at]} << 24 | size_t{data[at + 1]} << 16 |
                              size_t{data[at + 2]} << 8 | data[at + 3];
        if (length > size - at - kAround)
            return;
        const uint8_t* const end = data + at + 8 + length;
        uint32_t crc = ~0u; // CRC-32 of ISO 3309 over type and data
        for (const uint8_t* byte = data + at + 4; byte != end; ++byte) {
            crc ^= *byte;
            for (int bit = 0; bit < 8; ++bit)
                crc = crc >> 1 ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
        }
        for (int i = 0; i < 4; ++i)
            data[at + 8 + length + i] = static_cast<uint8_t>(~crc >> (24 - 8 * i));
        at += kAround + length;
    }
}

} // namespace calotype::fuzz
