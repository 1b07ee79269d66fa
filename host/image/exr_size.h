#pragma once

#include <filesystem>
#include <string_view>

#include "image/check_size.h"

namespace calotype {

/// The size of an EXR's data window, after a look at its last row: a few bytes can claim any number
/// of pixels, for which readExr would take memory before it met the missing ones. Throws SceneError
/// if the header or that row cannot be read, or a side exceeds `largestSide`.
ImageSize wholeExrSize(const std::filesystem::path& path, uint32_t largestSide);

bool isExr(std::string_view file);

} // namespace calotype
