#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/texel_image.h"

namespace calotype::test {

/// An sRGB-encoded image of 8-bit RGBA, in rows from the top.
inline std::shared_ptr<TexelImage> bytesImage(uint32_t width, uint32_t height,
                                              std::vector<uint8_t> bytes) {
    auto image = std::make_shared<TexelImage>();
    image->width = width;
    image->height = height;
    image->bytes = std::move(bytes);
    image->isEncoded = true;
    return image;
}

/// The oracle's: IEC 61966-2-1.
inline double decodedSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace calotype::test
