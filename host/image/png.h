#pragma once

#include <filesystem>
#include <string>

#include "image/image.h"

namespace calotype {

/// The bytes of an 8-bit RGB PNG, which says that it is sRGB. Throws OutputError if the picture is
/// too large for the format.
std::string encodePng(const Rgb8Image& image);

/// Writes an 8-bit RGB PNG, atomically. Throws OutputError.
void writePng(const std::filesystem::path& path, const Rgb8Image& image);

} // namespace calotype
