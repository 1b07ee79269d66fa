#include "film/write_picture.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "image/denoised_mark.h"
#include "image/exr.h"
#include "image/image_format.h"
#include "image/pfm.h"
#include "image/png.h"

namespace calotype {
namespace {

/// What the PNG of a denoised picture says. Any other has no texts: the same pixels are the same
/// file.
std::vector<PngText> textsOf(const Picture& picture) {
    const std::optional<DenoisedMark> mark = markOf(picture.metadata);
    if (!mark)
        return {};
    std::vector<Attribute> attributes;
    addMark(*mark, attributes);
    std::vector<PngText> texts = {{"Software", "Calotype " CALOTYPE_VERSION}};
    for (const Attribute& attribute : attributes) {
        const auto* number = std::get_if<double>(&attribute.value);
        texts.push_back({std::string(kMetadataPrefix) + attribute.name,
                         number ? shortNumber(*number) : std::get<std::string>(attribute.value)});
    }
    return texts;
}

} // namespace

void writePicture(const std::filesystem::path& path, const Picture& picture,
                  const DisplayTransform& transform) {
    const std::optional<ImageFormat> format = imageFormatOf(path);
    if (!format)
        throw OutputError("cannot write '" + path.string() +
                          "': its extension names no known picture format; use " +
                          std::string(kImageExtensions));
    switch (*format) {
    case ImageFormat::Png:
        return writePng(path, toDisplay(picture.color, transform, picture.alpha()),
                        textsOf(picture), alphaLevels(picture.alpha()));
    case ImageFormat::Exr:
        return writeExr(path, picture);
    case ImageFormat::Pfm:
        return writePfm(path, picture.color);
    }
}

} // namespace calotype
