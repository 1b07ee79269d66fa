#pragma once

#include <cstdint>

namespace calotype {

/// A rectangle of the film, in pixels from its top left corner.
struct Crop {
    uint32_t x = 0;
    uint32_t y = 0;
    uint32_t width = 0;
    uint32_t height = 0;
};

} // namespace calotype
