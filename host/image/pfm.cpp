#include "image/pfm.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <locale>
#include <sstream>
#include <string>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/error.h"

namespace calotype {
namespace {

static_assert(std::endian::native == std::endian::little && sizeof(glm::vec3) == 12);

void reverseBytesOfFloats(std::string& bytes) {
    for (size_t i = 0; i + sizeof(float) <= bytes.size(); i += sizeof(float)) {
        std::swap(bytes[i], bytes[i + 3]);
        std::swap(bytes[i + 1], bytes[i + 2]);
    }
}

} // namespace

void writePfm(const std::filesystem::path& path, const Image& image) {
    CALOTYPE_CHECK_LT(0u, image.pixels.size());
    std::string bytes =
        "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    const size_t rowBytes = size_t{image.width} * sizeof(glm::vec3);
    bytes.reserve(bytes.size() + rowBytes * image.height);
    for (uint32_t y = image.height; y-- > 0;)
        bytes.append(reinterpret_cast<const char*>(&image.at(0, y)), rowBytes);
    writeFileAtomically(path, bytes);
}

Image readPfm(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw SceneError(path.string(), "the file cannot be opened; check that it exists");
    file.imbue(std::locale::classic());
    std::string kind;
    uint32_t width = 0;
    uint32_t height = 0;
    double scale = 0.0;
    if (!(file >> kind >> width >> height >> scale) || kind != "PF" || width == 0 || height == 0 ||
        !std::isfinite(scale) || scale == 0.0)
        throw SceneError(path.string(), "the file does not begin like a colour PFM (PF, width, "
                                        "height, scale); write it anew");
    file.get(); // the one white space that ends the header

    std::ostringstream rest;
    rest << file.rdbuf();
    std::string bytes = std::move(rest).str();
    const uint64_t pixelCount = uint64_t{width} * height;
    if (bytes.size() % sizeof(glm::vec3) != 0 || bytes.size() / sizeof(glm::vec3) != pixelCount)
        throw SceneError(path.string(), "the file holds " + std::to_string(bytes.size()) +
                                            " bytes of pixels, which is not " +
                                            std::to_string(width) + " x " + std::to_string(height) +
                                            " pixels of 12 bytes; write it anew");
    if (scale > 0.0)
        reverseBytesOfFloats(bytes);

    Image image(width, height);
    const size_t rowBytes = size_t{width} * sizeof(glm::vec3);
    for (uint32_t y = 0; y < height; ++y)
        std::memcpy(&image.at(0, y), &bytes[(height - 1 - y) * rowBytes], rowBytes);
    return image;
}

} // namespace calotype
