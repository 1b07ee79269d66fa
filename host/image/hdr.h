#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "image/check_size.h"
#include "image/texel_image.h"

namespace calotype {

/// Reads Radiance's RGBE pictures ("#?RADIANCE"), with rows or columns from any corner; flat, or
/// run-length encoded in the old or the new way. The values are those of the file divided by all of
/// its EXPOSURE and COLORCORR, which Radiance multiplies pixels with. Throws SceneError at `where`
/// for sides of 0 or above `largestSide`, for files that are cut off or corrupt, and for XYZ,
/// encoded or other than Rec. 709 colours.
TexelImage readHdr(std::string_view file, uint32_t largestSide, const std::string& where);

bool isHdr(std::string_view file);

/// The size by the header; the rest of the file may be missing. Throws SceneError like readHdr.
ImageSize sizeOfHdr(std::string_view file, const std::string& where);

} // namespace calotype
