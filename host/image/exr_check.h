#pragma once

#include <filesystem>
#include <string_view>

#include "image/check_size.h"

namespace calotype {

/// Checks the header of an EXR file, because OpenEXR's classes allocate memory by it without
/// checks. Throws SceneError for attributes longer than the file, sides above 65,535 pixels, chunks
/// (blocks of rows, or tiles) above 256 MiB, more chunks than the file has room for, and deep
/// pixels. Returns the size of the data window.
ImageSize checkExr(const std::filesystem::path& path);

bool isExr(std::string_view file);

} // namespace calotype
