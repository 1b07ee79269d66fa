#pragma once

#include <filesystem>

#include "image/image.h"

namespace calotype {

/// Writes a colour PFM: 32-bit little-endian floats, bottom row first, bit for bit, atomically.
/// Throws OutputError. (Format: Debevec, http://www.pauldebevec.com/Research/HDR/PFM/)
void writePfm(const std::filesystem::path& path, const Image& image);

/// Reads a colour PFM of either byte order; ignores the absolute value of its scale. Throws
/// SceneError if the file cannot be read, is not a colour PFM, or has a wrong length.
Image readPfm(const std::filesystem::path& path);

} // namespace calotype
