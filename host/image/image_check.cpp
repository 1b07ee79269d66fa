#include "image/image_check.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "base/error.h"
#include "image/byte_order.h"

namespace calotype {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr size_t kBmpFileHeader = 14;
constexpr size_t kTgaHeader = 18;

[[noreturn]] void failCut(const std::string& where, const char* format) {
    throw SceneError(where, std::string("the ") + format + " is incomplete: its end is missing");
}

/// CRC-32 of ISO 3309, as PNG uses it.
uint32_t crc32(std::string_view bytes) {
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

/// The fields of a TGA's header that determine the size of the data.
struct TgaHeader {
    bool indexed;
    bool runLengthEncoded;
    ImageSize size;
    size_t bytesPerPixel;
    size_t pixels; ///< where they start
};

TgaHeader readTgaHeader(std::string_view file) {
    TgaHeader header;
    header.indexed = byteAt(file, 1) == 1;
    header.runLengthEncoded = byteAt(file, 2) >= 8;
    header.size = {littleEndian16(file, 12), littleEndian16(file, 14)};
    header.bytesPerPixel = (byteAt(file, 16) + 7) / 8;
    const size_t paletteEntry = (byteAt(file, 7) + 7) / 8;
    // stb_image skips the index of the first entry as if it were a number of bytes.
    const size_t palette =
        header.indexed ? littleEndian16(file, 3) + littleEndian16(file, 5) * paletteEntry : 0;
    header.pixels = kTgaHeader + byteAt(file, 0) + palette;
    return header;
}

/// Whether the packets of a run-length encoded TGA contain `pixels` pixels.
bool holdsPackets(std::string_view packets, uint64_t pixels, size_t bytesPerPixel) {
    size_t at = 0;
    while (pixels > 0) {
        if (at >= packets.size())
            return false;
        const uint32_t packet = byteAt(packets, at);
        const uint64_t count = (packet & 127u) + 1;
        at += 1 + bytesPerPixel * ((packet & 128u) != 0 ? 1 : count);
        pixels -= count < pixels ? count : pixels;
    }
    return at <= packets.size();
}

bool isOneOf(uint32_t value, std::initializer_list<uint32_t> allowed) {
    for (const uint32_t candidate : allowed)
        if (value == candidate)
            return true;
    return false;
}

} // namespace

bool isPng(std::string_view file) { return file.starts_with(kPngSignature); }

bool isJpeg(std::string_view file) { return file.starts_with("\xff\xd8\xff"); }

bool isBmp(std::string_view file) { return file.starts_with("BM"); }

bool isTga(std::string_view file) {
    if (file.size() < kTgaHeader)
        return false;
    const uint32_t type = byteAt(file, 2);
    const uint32_t depth = byteAt(file, 16);
    switch (byteAt(file, 1)) {
    case 0:
        return (isOneOf(type, {2, 10}) && isOneOf(depth, {15, 16, 24, 32})) ||
               (isOneOf(type, {3, 11}) && isOneOf(depth, {8, 16}));
    case 1:
        return isOneOf(type, {1, 9}) && isOneOf(depth, {8, 16}) &&
               isOneOf(byteAt(file, 7), {8, 15, 16, 24, 32});
    default:
        return false;
    }
}

ImageSize checkPng(std::string_view file, const std::string& where) {
    ImageSize size;
    size_t at = kPngSignature.size();
    std::string_view type;
    while (type != "IEND") {
        constexpr size_t kAround = 12; // length, type and checksum
        if (file.size() - at < kAround || file.size() - at - kAround < bigEndian32(file, at))
            failCut(where, "PNG");
        const size_t length = bigEndian32(file, at);
        type = file.substr(at + 4, 4);
        const bool isCritical = (byteAt(type, 0) & 32u) == 0;
        if (isCritical &&
            crc32(file.substr(at + 4, length + 4)) != bigEndian32(file, at + 8 + length))
            throw SceneError(where, "the PNG is corrupt: the checksum of a part is wrong");
        if (type == "IHDR" && length == 13)
            size = {bigEndian32(file, at + 8), bigEndian32(file, at + 12)};
        at += kAround + length;
    }
    return size;
}

ImageSize checkBmp(std::string_view file, const std::string& where) {
    constexpr size_t kSmallestHeader = 12;
    if (file.size() < kBmpFileHeader + kSmallestHeader)
        failCut(where, "BMP");
    const size_t offset = littleEndian32(file, 10);
    const size_t header = littleEndian32(file, 14);
    if (file.size() < kBmpFileHeader + header || offset < kBmpFileHeader + header)
        failCut(where, "BMP");
    const bool isOld = header == kSmallestHeader;
    if (!isOld && header < 40)
        throw SceneError(where, "the BMP is of a kind that cannot be read");
    ImageSize size;
    size.width = isOld ? littleEndian16(file, 18) : littleEndian32(file, 18);
    size.height = isOld ? littleEndian16(file, 20) : littleEndian32(file, 22);
    if (!isOld && size.height > INT32_MAX) // rows from the top
        size.height = 0u - size.height;
    const uint64_t depth = littleEndian16(file, isOld ? 24 : 28);
    const uint64_t row = (size.width * depth + 31) / 32 * 4;
    const bool isPlain = isOld || littleEndian32(file, 30) == 0 || littleEndian32(file, 30) == 3;
    if (isPlain && size.height > 0 &&
        (file.size() - std::min(file.size(), offset)) / size.height < row)
        failCut(where, "BMP");
    return size;
}

ImageSize checkTga(std::string_view file, const std::string& where) {
    const TgaHeader header = readTgaHeader(file);
    const uint64_t pixels = uint64_t{header.size.width} * header.size.height;
    const std::string_view data = file.substr(std::min(file.size(), header.pixels));
    const bool complete = header.runLengthEncoded ? holdsPackets(data, pixels, header.bytesPerPixel)
                                                  : data.size() >= pixels * header.bytesPerPixel;
    if (!complete)
        failCut(where, "TGA");
    return header.size;
}

} // namespace calotype
