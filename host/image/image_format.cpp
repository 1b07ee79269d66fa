#include "image/image_format.h"

#include <string>

namespace calotype {

std::optional<ImageFormat> imageFormatOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    if (extension == ".png")
        return ImageFormat::Png;
    if (extension == ".exr")
        return ImageFormat::Exr;
    if (extension == ".pfm")
        return ImageFormat::Pfm;
    return std::nullopt;
}

} // namespace calotype
