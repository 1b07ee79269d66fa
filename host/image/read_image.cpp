#include "image/read_image.h"

#include <fstream>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/file_kind.h"
#include "image/check_size.h"
#include "image/exr.h"
#include "image/exr_check.h"
#include "image/hdr.h"
#include "image/image_check.h"
#include "image/pfm.h"
#include "image/read_texel_image.h"
#include "image/srgb.h"
#include "image/texel_values.h"

namespace calotype {
namespace {

/// In bytes: a PFM, the least compact format, with the most pixels and a page for its header.
constexpr uintmax_t kLargestFile = kMostPicturePixels * sizeof(glm::vec3) + 4096;
/// In bytes: the longest signature, "#?RADIANCE".
constexpr size_t kSignature = 10;
constexpr const char* kUse = "compared"; ///< of pictures, for messages

std::ifstream openRegularFile(const std::filesystem::path& path) {
    std::error_code unknown;
    const auto status = std::filesystem::status(path, unknown);
    // Pipes and devices may block, or never end.
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw SceneError(path.string(), "the picture cannot be read: it is not a regular file");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw SceneError(path.string(),
                         "the picture cannot be opened; check that it exists and may be read");
    return file;
}

std::string readBytes(std::ifstream& file, size_t count) {
    std::string bytes(count, '\0');
    file.seekg(0);
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<size_t>(file.gcount()));
    file.clear();
    return bytes;
}

size_t sizeOfFile(const std::filesystem::path& path) {
    const uintmax_t size = std::filesystem::file_size(path);
    if (size > kLargestFile)
        throw SceneError(path.string(), "the picture is larger than 3 GiB; cut a part out of it");
    return size;
}

Image linearImage(const TexelImage& texels) {
    Image image(texels.width, texels.height);
    for (size_t i = 0; i < texels.texelCount(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            const float value = texelComponent(texels, i, channel);
            image.pixels[i][channel] =
                texels.isEncoded ? static_cast<float>(linearFromSrgb(value)) : value;
        }
    return image;
}

bool isPfm(std::string_view file) {
    return file.starts_with("PF\n") || file.starts_with("PF ") || file.starts_with("PF\r");
}

} // namespace

std::string signatureOf(const std::filesystem::path& path) {
    std::ifstream file = openRegularFile(path);
    return readBytes(file, kSignature);
}

Image readImage(const std::filesystem::path& path, uint64_t mostPixels) {
    const std::string where = path.string();
    std::ifstream file = openRegularFile(path);
    const std::string signature = readBytes(file, kSignature);
    if (isExr(signature)) {
        checkArea(checkExr(path), mostPixels, kUse, where);
        return readExr(path);
    }
    const size_t fileSize = sizeOfFile(path);
    if (isPfm(signature)) {
        Image image = readPfm(path);
        checkSize({image.width, image.height}, kLargestPictureSide, where);
        return image;
    }
    if (!isPng(signature) && !isHdr(signature)) {
        const std::string_view kind = fileKind(signature);
        throw SceneError(
            where, "the file is " +
                       (kind.empty() ? "not a picture that can be compared" : std::string(kind)) +
                       "; EXR, PFM (colour), HDR and PNG can be compared");
    }
    const std::string bytes = readBytes(file, fileSize);
    if (isPng(bytes))
        checkArea(checkPng(bytes, where), mostPixels, kUse, where);
    const TexelImage texels = readTexelImage(bytes, kLargestPictureSide, where);
    checkArea({texels.width, texels.height}, mostPixels, kUse, where);
    return linearImage(texels);
}

} // namespace calotype
