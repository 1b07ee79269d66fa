#include "image/texel_image_size.h"

#include <cstdio>
#include <memory>
#include <string_view>

#include <stb_image.h>

#include "base/error.h"
#include "base/read_file.h"
#include "image/hdr.h"
#include "image/image_check.h"
#include "image/stb_limit.h"
#include "image/tga.h"

namespace calotype {
namespace {

/// Headers of PNG, BMP, TGA and, as far as known, HDR are in the first bytes of a file.
constexpr size_t kFirstBytes = 65536;
/// Bytes; more than stb_image needs for any header.
constexpr size_t kMemoryForHeader = 1 << 20;
constexpr uint32_t kBytesOfFloats = 16;
constexpr uint32_t kBytesOfBytes = 4;

struct CloseImageFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string firstBytes(std::FILE* file) {
    std::string bytes(kFirstBytes, '\0');
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
    return bytes;
}

/// JPEGs may have other data of any length before their size, which are skipped.
std::optional<ImageSize> sizeByStb(std::FILE* file) {
    constexpr stbi_io_callbacks kCallbacks = {
        [](void* user, char* data, int size) {
            return static_cast<int>(
                std::fread(data, 1, static_cast<size_t>(size), static_cast<std::FILE*>(user)));
        },
        [](void* user, int count) { std::fseek(static_cast<std::FILE*>(user), count, SEEK_CUR); },
        [](void* user) {
            auto* const stream = static_cast<std::FILE*>(user);
            const int next = std::fgetc(stream);
            std::ungetc(next, stream);
            return next == EOF ? 1 : 0;
        }};
    int width = 0;
    int height = 0;
    int channels = 0;
    stbAllocationLimit = kMemoryForHeader;
    std::rewind(file);
    if (stbi_info_from_callbacks(&kCallbacks, file, &width, &height, &channels) == 0)
        return std::nullopt;
    return ImageSize{static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

bool isPngOfSixteenBits(std::string_view file) {
    constexpr size_t kBitDepth = 24; // in the header chunk
    return isPng(file) && file.size() > kBitDepth && file[kBitDepth] == 16;
}

} // namespace

std::optional<TexelImageSize> sizeOfTexelImage(const std::string& path) {
    if (!isReadableFile(path))
        return std::nullopt;
    const std::unique_ptr<std::FILE, CloseImageFile> file(std::fopen(path.c_str(), "rb"));
    if (!file)
        return std::nullopt;
    const std::string start = firstBytes(file.get());
    try {
        if (isHdr(start))
            return TexelImageSize{sizeOfHdr(start, path), kBytesOfFloats};
    } catch (const SceneError&) {
        return std::nullopt;
    }
    const bool isOfStb = isPng(start) || isJpeg(start) || isBmp(start);
    const std::optional<ImageSize> size = isOfStb        ? sizeByStb(file.get())
                                          : isTga(start) ? std::optional(sizeOfTga(start))
                                                         : std::nullopt;
    if (!size)
        return std::nullopt;
    return TexelImageSize{*size, isPngOfSixteenBits(start) ? kBytesOfFloats : kBytesOfBytes};
}

} // namespace calotype
