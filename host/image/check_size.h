#pragma once

#include <cstdint>
#include <string>

#include "base/error.h"

namespace calotype {

/// In pixels.
struct ImageSize {
    uint32_t width = 0;
    uint32_t height = 0;
};

/// Throws SceneError at `where` unless both sides are in [1, largestSide].
inline void checkSize(const ImageSize& size, uint32_t largestSide, const std::string& where) {
    if (size.width == 0 || size.height == 0)
        throw SceneError(where, "the image has no pixels");
    if (size.width > largestSide || size.height > largestSide)
        throw SceneError(where, "the image is " + std::to_string(size.width) + " x " +
                                    std::to_string(size.height) +
                                    " pixels, more than the largest side of " +
                                    std::to_string(largestSide) + "; scale it down");
}

/// Throws SceneError at `where` if there are more pixels than `mostPixels`, which "can be" `use`,
/// such as "compared". A small file can claim any size.
inline void checkArea(const ImageSize& size, uint64_t mostPixels, const std::string& use,
                      const std::string& where) {
    if (uint64_t{size.width} * size.height > mostPixels)
        throw SceneError(where, "the picture has " + std::to_string(size.width) + " x " +
                                    std::to_string(size.height) + " pixels, more than the " +
                                    std::to_string(mostPixels) + " that can be " + use +
                                    "; cut a part out of it");
}

} // namespace calotype
