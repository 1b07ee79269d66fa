#include "image/read_texel_image.h"

#include <algorithm>
#include <limits>
#include <memory>

#include <stb_image.h>

#include "base/error.h"
#include "base/file_kind.h"
#include "image/hdr.h"
#include "image/image_check.h"
#include "image/jpeg_check.h"
#include "image/stb_limit.h"
#include "image/tga.h"

namespace calotype {
namespace {

struct StbFormat {
    const char* name;
    bool (*matches)(std::string_view file);
    ImageSize (*check)(std::string_view file, const std::string& where);
};

constexpr StbFormat kStbFormats[] = {
    {"PNG", isPng, checkPng}, {"JPEG", isJpeg, checkJpeg}, {"BMP", isBmp, checkBmp}};

struct FreeStb {
    void operator()(void* memory) const { stbi_image_free(memory); }
};

/// More than any buffer of stb_image needs: JPEG's planes are padded to blocks of up to 32 pixels;
/// PNG's rows have up to 8 bytes per pixel and their buffer grows by doubling.
size_t memoryFor(const ImageSize& size, size_t fileSize) {
    constexpr size_t kBytesPerPixel = 16;
    constexpr size_t kPadding = 64;
    constexpr size_t kTables = size_t{1} << 20;
    return kBytesPerPixel * (size.width + kPadding) * (size.height + kPadding) + 2 * fileSize +
           kTables;
}

/// Calls one of stb_image's loaders on the file.
template <typename Sample>
std::unique_ptr<Sample, FreeStb> decode(Sample* (*load)(const stbi_uc*, int, int*, int*, int*, int),
                                        std::string_view file, const StbFormat& format,
                                        const ImageSize& size, const std::string& where) {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::unique_ptr<Sample, FreeStb> samples(load(reinterpret_cast<const stbi_uc*>(file.data()),
                                                  static_cast<int>(file.size()), &width, &height,
                                                  &channels, kTexelChannels));
    if (!samples)
        throw SceneError(where, std::string("the ") + format.name +
                                    " is corrupt or of a kind that cannot be read (" +
                                    stbi_failure_reason() + ")");
    if (static_cast<uint32_t>(width) != size.width || static_cast<uint32_t>(height) != size.height)
        throw SceneError(where,
                         std::string("the ") + format.name + " is corrupt: its size changes");
    return samples;
}

template <typename Sample>
bool anyTransparent(const std::vector<Sample>& samples, Sample opaque) {
    for (size_t i = kTexelChannels - 1; i < samples.size(); i += kTexelChannels)
        if (samples[i] < opaque)
            return true;
    return false;
}

void makeOpaque(std::vector<uint8_t>& bytes) {
    for (size_t i = kTexelChannels - 1; i < bytes.size(); i += kTexelChannels)
        bytes[i] = 255;
}

TexelImage readWithStb(const StbFormat& format, std::string_view file, uint32_t largestSide,
                       const std::string& where) {
    const ImageSize size = format.check(file, where);
    checkSize(size, largestSide, where);
    const std::string rewritten = isBmp(file) ? withHeaderOfVersion4(file) : std::string();
    if (!rewritten.empty())
        file = rewritten;
    stbAllocationLimit = memoryFor(size, file.size());
    TexelImage image;
    image.width = size.width;
    image.height = size.height;
    image.isEncoded = true;
    const size_t count = image.texelCount() * kTexelChannels;
    if (stbi_is_16_bit_from_memory(reinterpret_cast<const stbi_uc*>(file.data()),
                                   static_cast<int>(file.size())) != 0) {
        const auto samples = decode(stbi_load_16_from_memory, file, format, size, where);
        image.floats.resize(count);
        std::transform(samples.get(), samples.get() + count, image.floats.begin(),
                       [](stbi_us sample) { return static_cast<float>(sample) / 65535.0f; });
        image.isTransparent = anyTransparent(image.floats, 1.0f);
    } else {
        const auto samples = decode(stbi_load_from_memory, file, format, size, where);
        image.bytes.assign(samples.get(), samples.get() + count);
        if (isBmp(file) && hasReservedByte(file)) // stb_image takes it for alpha
            makeOpaque(image.bytes);
        image.isTransparent = anyTransparent<uint8_t>(image.bytes, 255);
    }
    return image;
}

} // namespace

TexelImage readTexelImage(std::string_view file, uint32_t largestSide, const std::string& where) {
    if (file.size() > std::numeric_limits<int>::max())
        throw SceneError(where, "the image file is larger than 2 GiB");
    if (isHdr(file))
        return readHdr(file, largestSide, where);
    for (const StbFormat& format : kStbFormats)
        if (format.matches(file))
            return readWithStb(format, file, largestSide, where);
    if (isTga(file)) // last: it has no signature
        return readTga(file, largestSide, where);
    const std::string_view kind = fileKind(file);
    throw SceneError(where, kind.empty() ? "the file is not an image that can be read: PNG, JPEG, "
                                           "TGA, BMP and HDR are"
                                         : "the file is " + std::string(kind) +
                                               ", which cannot be read: PNG, JPEG, TGA, BMP and "
                                               "HDR can");
}

} // namespace calotype
