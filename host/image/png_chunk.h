#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace calotype {

/// CRC-32 of ISO 3309, as PNG uses it.
uint32_t pngChecksum(std::string_view bytes);

/// A text in a PNG file: the chunk tEXt.
struct PngText {
    std::string keyword; ///< 1 to 79 printable characters of ASCII
    std::string text;    ///< other characters than printable ones of ASCII are written as '?'
};

/// The chunk, with its length and checksum.
std::string pngChunk(const PngText& text);

/// The texts in a PNG file whose chunks are whole (checkPng of image/image_check.h).
std::vector<PngText> pngTexts(std::string_view file);

} // namespace calotype
