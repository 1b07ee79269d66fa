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

} // namespace calotype
