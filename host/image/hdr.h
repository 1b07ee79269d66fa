#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "image/texel_image.h"

namespace calotype {

/// Reads Radiance's RGBE pictures ("#?RADIANCE", rows from the top, flat or run-length encoded).
/// The values are those of the file: EXPOSURE and PRIMARIES are ignored. Throws SceneError at
/// `where` for sides of 0 or above `largestSide` and for files that are cut off or corrupt.
TexelImage readHdr(std::string_view file, uint32_t largestSide, const std::string& where);

bool isHdr(std::string_view file);

} // namespace calotype
