#include "image/png_chunk.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "image/byte_order.h"

namespace calotype {
namespace {

constexpr std::string_view kTextType = "tEXt";

void appendBigEndian(std::string& bytes, uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(number >> shift);
}

} // namespace

uint32_t pngChecksum(std::string_view bytes) {
    static const std::array<uint32_t, 256> kTable = [] {
        std::array<uint32_t, 256> table{};
        for (uint32_t i = 0; i < table.size(); ++i) {
            table[i] = i;
            for (int bit = 0; bit < 8; ++bit)
                table[i] = (table[i] & 1u) != 0 ? 0xedb88320u ^ (table[i] >> 1) : table[i] >> 1;
        }
        return table;
    }();
    uint32_t crc = ~0u;
    for (const char c : bytes)
        crc = kTable[(crc ^ static_cast<unsigned char>(c)) & 255u] ^ (crc >> 8);
    return ~crc;
}

std::string pngChunk(const PngText& text) {
    CALOTYPE_CHECK_EQ(!text.keyword.empty() && text.keyword.size() < 80, true);
    std::string contents = text.keyword + '\0' + text.text;
    std::replace_if(
        contents.begin() + static_cast<std::ptrdiff_t>(text.keyword.size() + 1), contents.end(),
        [](char c) { return c < ' ' || c > '~'; }, '?');
    const std::string named = std::string(kTextType) + contents;
    std::string chunk;
    appendBigEndian(chunk, static_cast<uint32_t>(contents.size()));
    chunk += named;
    appendBigEndian(chunk, pngChecksum(named));
    return chunk;
}

std::vector<PngText> pngTexts(std::string_view file) {
    constexpr size_t kSignature = 8;
    constexpr size_t kAround = 12; // length, type and checksum
    std::vector<PngText> texts;
    for (size_t at = kSignature; at + kAround <= file.size();) {
        const size_t length = bigEndian32(file, at);
        if (length > file.size() - at - kAround)
            break;
        const std::string_view contents = file.substr(at + 8, length);
        const size_t end = contents.find('\0');
        if (file.substr(at + 4, 4) == kTextType && end != std::string_view::npos)
            texts.push_back(
                {std::string(contents.substr(0, end)), std::string(contents.substr(end + 1))});
        at += kAround + length;
    }
    return texts;
}

} // namespace calotype
