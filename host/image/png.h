#pragma once

#include <filesystem>

#include "image/rgb8_image.h"

namespace calotype {

/// Writes an 8-bit RGB PNG, whole at every moment. Throws OutputError.
void writePng(const std::filesystem::path& path, const Rgb8Image& image);

} // namespace calotype
