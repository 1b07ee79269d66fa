#pragma once

#include "image/texel_channel.h"

namespace calotype {

/// An opaque grey image of one channel of `image`, not encoded.
TexelImage greyImage(const TexelImage& image, TexelChannel channel);

/// A white image whose alpha is one channel of `image`, clamped to [0, 1].
TexelImage alphaImage(const TexelImage& image, TexelChannel channel);

} // namespace calotype
