#include "image/png.h"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec4.hpp>
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

/// Nothing if there is no alpha.
std::vector<glm::u8vec4> joined(const Rgb8Image& image, std::span<const uint8_t> alpha) {
    std::vector<glm::u8vec4> pixels;
    if (alpha.empty())
        return pixels;
    CALOTYPE_CHECK_EQ(alpha.size(), image.pixels.size());
    pixels.reserve(alpha.size());
    for (size_t i = 0; i < alpha.size(); ++i)
        pixels.emplace_back(image.pixels[i], alpha[i]);
    return pixels;
}

} // namespace

std::string encodePng(const Rgb8Image& image, std::span<const PngText> texts,
                      std::span<const uint8_t> alpha) {
    CALOTYPE_CHECK_LT(0u, image.pixels.size());
    const std::vector<glm::u8vec4> withAlpha = joined(image, alpha);
    const int channels = alpha.empty() ? 3 : 4;
    const void* pixels = alpha.empty() ? static_cast<const void*>(image.pixels.data())
                                       : static_cast<const void*>(withAlpha.data());

    // stb counts bytes in int, and its buffer grows by doubling. Each row has one byte more.
    const uint64_t bytesToPack = (uint64_t{image.width} * channels + 1) * image.height;
    if (bytesToPack > std::numeric_limits<int>::max() / 2)
        throw OutputError(std::to_string(image.width) + " x " + std::to_string(image.height) +
                          " pixels are too many for a PNG; use .exr or .pfm");
    std::string bytes;
    const int width = static_cast<int>(image.width);
    const int height = static_cast<int>(image.height);
    if (!stbi_write_png_to_func(append, &bytes, width, height, channels, pixels, width * channels))
        throw OutputError("not enough memory to compress the PNG; use .exr or .pfm");
    constexpr size_t kHeaderEnd = 8 + 25; // the signature, and IHDR
    std::string added(kSrgbChunk);
    for (const PngText& text : texts)
        added += pngChunk(text);
    return bytes.insert(kHeaderEnd, added);
}

void writePng(const std::filesystem::path& path, const Rgb8Image& image,
              std::span<const PngText> texts, std::span<const uint8_t> alpha) {
    std::string bytes;
    try {
        bytes = encodePng(image, texts, alpha);
    } catch (const OutputError& error) {
        throw OutputError("cannot write '" + path.string() + "': " + error.what());
    }
    writeFileAtomically(path, bytes);
}

} // namespace calotype
