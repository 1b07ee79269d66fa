#include "film/write_image.h"

#include <string>

#include "base/error.h"
#include "image/image_format.h"
#include "image/pfm.h"
#include "image/png.h"

namespace calotype {

void writeImage(const std::filesystem::path& path, const Image& image,
                const DisplayTransform& transform, const ExrMetadata& metadata,
                const ExrLayers& layers) {
    const std::optional<ImageFormat> format = imageFormatOf(path);
    if (!format)
        throw OutputError("cannot write '" + path.string() +
                          "': its extension names no known picture format; use " +
                          std::string(kImageExtensions));
    switch (*format) {
    case ImageFormat::Png:
        return writePng(path, toDisplay(image, transform));
    case ImageFormat::Exr:
        return writeExr(path, image, metadata, layers);
    case ImageFormat::Pfm:
        return writePfm(path, image);
    }
}

} // namespace calotype
