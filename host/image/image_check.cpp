#include "image/image_check.h"

#include <algorithm>

#include "base/error.h"
#include "image/byte_order.h"
#include "image/png_chunk.h"

namespace calotype {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr size_t kBmpFileHeader = 14;

[[noreturn]] void failCut(const std::string& where, const char* format) {
    throw SceneError(where, std::string("the ") + format + " is incomplete: its end is missing");
}

} // namespace

bool isPng(std::string_view file) { return file.starts_with(kPngSignature); }

bool isJpeg(std::string_view file) { return file.starts_with("\xff\xd8\xff"); }

bool isBmp(std::string_view file) { return file.starts_with("BM"); }

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
            pngChecksum(file.substr(at + 4, length + 4)) != bigEndian32(file, at + 8 + length))
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

std::string withHeaderOfVersion4(std::string_view bmp) {
    constexpr uint32_t kVersion4 = 108;
    const uint32_t header = littleEndian32(bmp, 14);
    if (header != 52 && header != 56)
        return {};
    const uint32_t added = kVersion4 - header;
    std::string result(bmp.substr(0, kBmpFileHeader + header));
    result.append(added, '\0').append(bmp.substr(kBmpFileHeader + header));
    const auto write = [&](size_t at, uint32_t value) {
        for (int i = 0; i < 4; ++i)
            result[at + i] = static_cast<char>(value >> (8 * i));
    };
    write(10, littleEndian32(bmp, 10) + added);
    write(14, kVersion4);
    return result;
}

bool hasReservedByte(std::string_view bmp) {
    constexpr size_t kCompressionEnd = 34;
    return bmp.size() >= kCompressionEnd && littleEndian32(bmp, 14) >= 40 &&
           littleEndian16(bmp, 28) == 32 && littleEndian32(bmp, 30) == 0;
}

} // namespace calotype
