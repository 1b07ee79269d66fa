#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace calotype {

inline constexpr size_t kTexelChannels = 4; ///< red, green, blue, alpha

/// The image of a texture: RGBA texels, row 0 at the top, in one of two forms. Grey images have
/// three equal channels; images without alpha have alpha 1.
struct TexelImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> bytes; ///< width * height * 4 values, 255 is 1; or empty
    std::vector<float> floats;  ///< width * height * 4 values; or empty
    bool isEncoded = false;     ///< colours are sRGB-encoded, as in files of 8 and 16 bits
    bool isTransparent = false; ///< some alpha is below 1

    bool holdsBytes() const { return !bytes.empty(); }
    size_t texelCount() const { return size_t{width} * height; }
};

} // namespace calotype
