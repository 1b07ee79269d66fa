#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "image/image.h"
#include "image/png_chunk.h"

namespace calotype {

/// The bytes of an 8-bit RGB PNG, which says that it is sRGB, with these texts. Throws OutputError
/// if the picture is too large for the format.
std::string encodePng(const Rgb8Image& image, std::span<const PngText> texts = {});

/// Writes such a PNG, atomically. Throws OutputError.
void writePng(const std::filesystem::path& path, const Rgb8Image& image,
              std::span<const PngText> texts = {});

} // namespace calotype
