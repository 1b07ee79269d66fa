#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "image/check_size.h"

namespace calotype {

/// The header of a Radiance picture. A row is a line of pixels as the file stores it.
struct HdrHeader {
    ImageSize size;
    bool storesColumns = false;                         ///< rows are columns of the picture
    bool startsRight = false;                           ///< its first pixel is in the last column
    bool startsAtBottom = false;                        ///< its first pixel is in the lowest row
    std::array<double, 3> correction = {1.0, 1.0, 1.0}; ///< by which red, green, blue are divided

    uint32_t rowLength() const { return storesColumns ? size.height : size.width; }
    uint32_t rowCount() const { return storesColumns ? size.width : size.height; }

    /// The index of pixel `j` of row `i` in a picture with rows from the top.
    size_t texelAt(uint32_t i, uint32_t j) const {
        const uint32_t column = storesColumns ? i : j;
        const uint32_t line = storesColumns ? j : i;
        const size_t x = startsRight ? size.width - 1 - column : column;
        const size_t y = startsAtBottom ? size.height - 1 - line : line;
        return y * size.width + x;
    }
};

/// Reads the header, and removes it from `file`. Throws SceneError at `where` for a header that is
/// cut off or malformed, and for pixels that readHdr cannot read.
HdrHeader readHdrHeader(std::string_view& file, const std::string& where);

} // namespace calotype
