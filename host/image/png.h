#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "image/image.h"
#include "image/png_chunk.h"

namespace calotype {

/// The bytes of an 8-bit PNG, which says that it is sRGB, with these texts: RGBA if `alpha` has a
/// value for each pixel, and RGB if it is empty. The colours are not multiplied by alpha. Throws
/// OutputError if the picture is too large for the format.
std::string encodePng(const Rgb8Image& image, std::span<const PngText> texts = {},
                      std::span<const uint8_t> alpha = {});

/// Writes such a PNG, atomically. Throws OutputError.
void writePng(const std::filesystem::path& path, const Rgb8Image& image,
              std::span<const PngText> texts = {}, std::span<const uint8_t> alpha = {});

} // namespace calotype
