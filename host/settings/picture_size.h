#pragma once

#include <cstdint>

namespace calotype {

/// Width and height in pixels.
struct PictureSize {
    uint32_t width = 0;
    uint32_t height = 0;
};

} // namespace calotype
