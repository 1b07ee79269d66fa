#pragma once

#include <string>
#include <string_view>

#include "image/check_size.h"

namespace calotype {

/// The size of a JPEG by its header, after a look for Huffman tables of more than 256 codes, past
/// whose memory stb_image would write. Throws SceneError at `where`.
ImageSize checkJpeg(std::string_view file, const std::string& where);

} // namespace calotype
