#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

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

/// An opaque grey image of one channel of `image`, not encoded.
TexelImage greyImage(const TexelImage& image, TexelChannel channel);

/// A white image whose alpha is one channel of `image`, clamped to [0, 1].
TexelImage alphaImage(const TexelImage& image, TexelChannel channel);

enum class AlphaWeights : uint8_t { No, Yes };

/// The mean colour of an image. `decode` makes sRGB-encoded colours linear before averaging, like a
/// colour slot. With AlphaWeights::Yes each texel is weighted by its alpha; an image whose texels
/// are all transparent has the mean without weights.
glm::dvec3 meanColor(const TexelImage& image, bool decode, AlphaWeights weights = AlphaWeights::No);

/// The least and the greatest value of red, green and blue over all texels of an image, bytes
/// scaled to [0, 1], not decoded.
struct TexelRange {
    glm::dvec3 least{0.0};
    glm::dvec3 greatest{0.0};
};

/// The image must not be empty.
TexelRange texelRange(const TexelImage& image);

} // namespace calotype
