#pragma once

#include <filesystem>

#include "image/image.h"

namespace calotype {

/// Writes a colour PFM: 32-bit little-endian floats, bottom row first, bit for bit, whole at every
/// moment. Throws OutputError. (Format: Debevec, http://www.pauldebevec.com/Research/HDR/PFM/)
void writePfm(const std::filesystem::path& path, const Image& image);

/// Reads a colour PFM of either byte order; the size of its scale is ignored. Throws SceneError if
/// the file cannot be read, is not a colour PFM, or is not as long as it says.
Image readPfm(const std::filesystem::path& path);

} // namespace calotype
