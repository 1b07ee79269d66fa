#pragma once

#include <string>
#include <string_view>

#include "image/check_size.h"

namespace calotype {

/// The size of a JPEG from its header. Throws SceneError at `where`, also if the file is cut off,
/// and for Huffman tables of more than 256 codes, with which stb_image would write outside its
/// memory.
ImageSize checkJpeg(std::string_view file, const std::string& where);

} // namespace calotype
