#include "image/jpeg_check.h"

#include <stb_image.h>

#include "base/error.h"
#include "image/byte_order.h"
#include "image/stb_limit.h"

namespace calotype {
namespace {

/// More than the memory that stb_image takes to read a header.
constexpr size_t kHeaderMemory = size_t{1} << 20;

/// Markers, the byte after 0xff, of ITU-T T.81 (table B.1).
constexpr uint32_t kStuffing = 0x00;
constexpr uint32_t kHuffmanTables = 0xc4;
constexpr uint32_t kFirstRestart = 0xd0;
constexpr uint32_t kLastRestart = 0xd7;
constexpr uint32_t kStart = 0xd8;
constexpr uint32_t kEnd = 0xd9;
constexpr uint32_t kFill = 0xff;

/// Whether the Huffman tables of a segment have at most 256 codes each.
bool areTablesSound(std::string_view tables) {
    constexpr size_t kLengths = 16;
    constexpr size_t kMostCodes = 256;
    while (!tables.empty()) {
        if (tables.size() < 1 + kLengths)
            return false;
        size_t codes = 0;
        for (size_t i = 1; i <= kLengths; ++i)
            codes += byteAt(tables, i);
        if (codes > kMostCodes || tables.size() < 1 + kLengths + codes)
            return false;
        tables.remove_prefix(1 + kLengths + codes);
    }
    return true;
}

/// Visits all markers, also after compressed data, to the one that ends the picture. False if a
/// segment is malformed, or if there is no end: newer versions of stb_image accept files that are
/// cut off.
bool isWhole(std::string_view file) {
    size_t at = file.find('\xff');
    while (at != std::string_view::npos && file.size() - at >= 2) {
        const uint32_t marker = byteAt(file, at + 1);
        const bool standsAlone = marker == kStuffing || marker == kStart ||
                                 (marker >= kFirstRestart && marker <= kLastRestart);
        if (marker == kEnd)
            return true;
        if (marker == kFill || standsAlone) {
            at = file.find('\xff', at + (standsAlone ? 2 : 1));
            continue;
        }
        if (file.size() - at < 4)
            return false;
        const size_t length = byteAt(file, at + 2) << 8 | byteAt(file, at + 3);
        if (length < 2 || file.size() - at - 2 < length)
            return false;
        if (marker == kHuffmanTables && !areTablesSound(file.substr(at + 4, length - 2)))
            return false;
        at = file.find('\xff', at + 2 + length);
    }
    return false;
}

} // namespace

ImageSize checkJpeg(std::string_view file, const std::string& where) {
    if (!isWhole(file))
        throw SceneError(where, "the JPEG is corrupt: a part of it is cut off or malformed");
    int width = 0;
    int height = 0;
    int channels = 0;
    stbAllocationLimit = kHeaderMemory;
    if (stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(file.data()),
                              static_cast<int>(file.size()), &width, &height, &channels) == 0)
        throw SceneError(where, std::string("the JPEG is corrupt or of a kind that cannot be read "
                                            "(its header: ") +
                                    stbi_failure_reason() + ")");
    return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

} // namespace calotype
