#pragma once

#include <string>
#include <string_view>

#include "image/check_size.h"

namespace calotype {

/// The size of a picture by its file's header, after a look for what stb_image passes over in
/// silence: chunks that are cut off or whose checksum is wrong (PNG), pixels that are missing (BMP,
/// TGA). All throw SceneError at `where`.
ImageSize checkPng(std::string_view file, const std::string& where);
ImageSize checkBmp(std::string_view file, const std::string& where);
ImageSize checkTga(std::string_view file, const std::string& where);

bool isPng(std::string_view file);
bool isJpeg(std::string_view file);
bool isBmp(std::string_view file);
/// TGA has no signature: whether the header makes sense as one.
bool isTga(std::string_view file);

} // namespace calotype
