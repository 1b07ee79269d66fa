#pragma once

#include <string>
#include <string_view>

#include "image/check_size.h"

namespace calotype {

/// Each returns the size of a picture from the file's header, and checks what stb_image does not:
/// chunks that are cut off or have a wrong checksum (PNG), missing pixels (BMP). Each throws
/// SceneError at `where`.
ImageSize checkPng(std::string_view file, const std::string& where);
ImageSize checkBmp(std::string_view file, const std::string& where);

bool isPng(std::string_view file);
bool isJpeg(std::string_view file);
bool isBmp(std::string_view file);

/// A BMP with the header of version 4 in place of one of version 2 or 3, whose masks stb_image does
/// not read; empty for any other header. The file must have been checked.
std::string withHeaderOfVersion4(std::string_view bmp);

/// Whether the fourth byte of each pixel of a BMP has no meaning: it has 32 bits per pixel and
/// states no masks (BI_RGB).
bool hasReservedByte(std::string_view bmp);

} // namespace calotype
