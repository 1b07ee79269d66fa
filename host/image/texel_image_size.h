#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "image/check_size.h"

namespace calotype {

/// What an image takes once it is decoded.
struct TexelImageSize {
    ImageSize size;
    uint32_t bytesPerTexel = 4;

    uint64_t bytes() const { return uint64_t{size.width} * size.height * bytesPerTexel; }
};

/// Reads the header of an image file, and no more. Empty if it cannot be read; readTexelImage gives
/// the reason.
std::optional<TexelImageSize> sizeOfTexelImage(const std::string& path);

} // namespace calotype
