#pragma once

#include <cstdint>

#include "image/texel_image.h"

namespace calotype {

enum class TexelChannel : uint8_t { Red, Green, Blue, Alpha, Luminance };

/// One channel (0 to 3) of the texel `index`, bytes scaled to [0, 1].
inline float texelComponent(const TexelImage& image, size_t index, int channel) {
    const size_t at = 4 * index + static_cast<size_t>(channel);
    return image.holdsBytes() ? static_cast<float>(image.bytes[at]) / 255.0f : image.floats[at];
}

/// The value that a scalar slot reads; luminance has the weights of Rec. 709. Nothing is decoded.
inline float texelValue(const TexelImage& image, size_t index, TexelChannel channel) {
    if (channel != TexelChannel::Luminance)
        return texelComponent(image, index, static_cast<int>(channel));
    return 0.2126f * texelComponent(image, index, 0) + 0.7152f * texelComponent(image, index, 1) +
           0.0722f * texelComponent(image, index, 2);
}

} // namespace calotype
