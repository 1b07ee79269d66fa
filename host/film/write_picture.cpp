#include "film/write_picture.h"

#include <optional>
#include <string>

#include "base/error.h"
#include "image/exr.h"
#include "image/image_format.h"
#include "image/pfm.h"
#include "image/png.h"

namespace calotype {

void writePicture(const std::filesystem::path& path, const Picture& picture,
                  const DisplayTransform& transform) {
    const std::optional<ImageFormat> format = imageFormatOf(path);
    if (!format)
        throw OutputError("cannot write '" + path.string() +
                          "': its extension names no known picture format; use " +
                          std::string(kImageExtensions));
    switch (*format) {
    case ImageFormat::Png:
        return writePng(path, toDisplay(picture.color, transform));
    case ImageFormat::Exr:
        return writeExr(path, picture);
    case ImageFormat::Pfm:
        return writePfm(path, picture.color);
    }
}

} // namespace calotype
