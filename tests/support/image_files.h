#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <stb/stb_image_write.h>

/// Image files in memory.
namespace calotype::test {

inline void appendBigEndian(std::string& bytes, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(value >> shift);
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
    std::string bytes;
    appendBigEndian(bytes, static_cast<uint32_t>(data.size()));
    uint32_t crc = ~0u;
    for (const char c : type + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc % 2 * 0xedb88320u);
    }
    bytes += type + data;
    appendBigEndian(bytes, ~crc);
    return bytes;
}

/// An EXR file, with the red primary of DCI-P3 instead of its own.
inline std::string withOtherPrimaries(std::string exr) {
    const std::string attribute("chromaticities\0chromaticities", 29); // its name and type
    const float red[] = {0.68f, 0.32f};
    std::memcpy(&exr.at(exr.find(attribute) + attribute.size() + 1 + sizeof(int32_t)), red,
                sizeof red);
    return exr;
}

/// A PNG whose rows, filter bytes included, are stored without compression (65535 bytes at most).
inline std::string pngFile(uint32_t width, uint32_t height, int depth, int colorType,
                           const std::string& rows) {
    std::string header;
    appendBigEndian(header, width);
    appendBigEndian(header, height);
    header += {static_cast<char>(depth), static_cast<char>(colorType), 0, 0, 0};
    const auto length = static_cast<uint32_t>(rows.size());
    std::string data = "\x78\x01\x01";
    data += {static_cast<char>(length), static_cast<char>(length >> 8), static_cast<char>(~length),
             static_cast<char>(~length >> 8)};
    uint32_t a = 1;
    uint32_t b = 0;
    for (const char c : rows) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    data += rows;
    appendBigEndian(data, b << 16 | a);
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + pngChunk("IDAT", data) +
           pngChunk("IEND", "");
}

inline void appendTo(void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), size);
}

using Rgba8 = std::array<uint8_t, 4>;

/// A PNG of 8 bits with alpha, row by row from the top.
inline std::string pngOf(int width, int height, const std::vector<Rgba8>& texels) {
    std::string bytes;
    stbi_write_png_to_func(appendTo, &bytes, width, height, 4, texels.data(), 4 * width);
    return bytes;
}

/// A PNG of one colour.
inline std::string pngOf(const Rgba8& color, int side = 2) {
    return pngOf(side, side, std::vector<Rgba8>(side * side, color));
}

} // namespace calotype::test
