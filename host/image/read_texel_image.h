#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "image/texel_image.h"

namespace calotype {

/// Decodes the bytes of a PNG, JPEG, TGA, BMP or HDR file; the content decides the format. 8-bit
/// files fill `bytes`; PNGs of 16 bits, in [0, 1], and HDR pictures fill `floats`. Ignores colour
/// profiles, gAMA chunks and orientation tags. Throws SceneError at `where` (the file's name) for
/// other content, for sides of 0 or above `largestSide` (before anything is decoded) and for files
/// that are cut off or corrupt.
TexelImage readTexelImage(std::string_view file, uint32_t largestSide, const std::string& where);

} // namespace calotype
