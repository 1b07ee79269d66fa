#pragma once

#include <filesystem>
#include <string>

#include "image/image.h"

namespace calotype {

/// The bytes of an 8-bit RGB PNG. Throws OutputError where the picture is too large for one.
std::string encodePng(const Rgb8Image& image);

/// Writes an 8-bit RGB PNG, whole at every moment. Throws OutputError.
void writePng(const std::filesystem::path& path, const Rgb8Image& image);

} // namespace calotype
