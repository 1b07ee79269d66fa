#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "image/check_size.h"
#include "image/texel_image.h"

namespace calotype {

/// Reads a TGA (Truevision's specification 2.0): colours of 15 to 32 bits, colour maps, grey of 8
/// bits with or without alpha; each plain or run-length encoded, from any corner. Texels are
/// transparent only if the header counts bits of alpha, and the extension area, if there is one,
/// does not say that they have no meaning. Throws SceneError at `where` for sides of 0 or above
/// `largestSide`, for files that are cut off or corrupt, and for other kinds.
TexelImage readTga(std::string_view file, uint32_t largestSide, const std::string& where);

/// Whether the file begins with a valid header of a TGA. TGA files have no signature.
bool isTga(std::string_view file);

/// The size that the header states; the file must begin with a valid one.
ImageSize sizeOfTga(std::string_view file);

} // namespace calotype
