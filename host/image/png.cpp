#include "image/png.h"

#include <limits>
#include <string>
#include <string_view>

#include <stb_image_write.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/error.h"

namespace calotype {
namespace {

void append(void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), size);
}

/// The chunk that says that the numbers are sRGB, for the rendering intent "perceptual": the number
/// of its bytes, its name, the intent, and the checksum of both.
constexpr std::string_view kSrgbChunk("\0\0\0\1sRGB\0\xAE\xCE\x1C\xE9", 13);

} // namespace

std::string encodePng(const Rgb8Image& image, std::span<const PngText> texts) {
    CALOTYPE_CHECK_LT(0u, image.pixels.size());
    constexpr int kChannels = 3;

    // stb counts bytes in int, and its buffer grows by doubling. Each row has one byte more.
    const uint64_t bytesToPack = (uint64_t{image.width} * kChannels + 1) * image.height;
    if (bytesToPack > std::numeric_limits<int>::max() / 2)
        throw OutputError(std::to_string(image.width) + " x " + std::to_string(image.height) +
                          " pixels are too many for a PNG; use .exr or .pfm");
    std::string bytes;
    const int width = static_cast<int>(image.width);
    const int height = static_cast<int>(image.height);
    if (!stbi_write_png_to_func(append, &bytes, width, height, kChannels, image.pixels.data(),
                                width * kChannels))
        throw OutputError("not enough memory to compress the PNG; use .exr or .pfm");
    constexpr size_t kHeaderEnd = 8 + 25; // the signature, and IHDR
    std::string added(kSrgbChunk);
    for (const PngText& text : texts)
        added += pngChunk(text);
    return bytes.insert(kHeaderEnd, added);
}

void writePng(const std::filesystem::path& path, const Rgb8Image& image,
              std::span<const PngText> texts) {
    std::string bytes;
    try {
        bytes = encodePng(image, texts);
    } catch (const OutputError& error) {
        throw OutputError("cannot write '" + path.string() + "': " + error.what());
    }
    writeFileAtomically(path, bytes);
}

} // namespace calotype
