#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "image/texel_image.h"

namespace calotype {

constexpr size_t kBytesOfTexelRow = 16;

/// The texels of an image as kernels read them, in rows of 16 bytes: four texels of 8-bit RGBA, or
/// one of four floats. They stay in the image, so that the host has no second copy.
struct TexelRows {
    std::shared_ptr<const TexelImage> image; ///< nullptr: one row that is not used

    std::span<const std::byte> bytes() const {
        static constexpr std::byte kUnused[kBytesOfTexelRow] = {};
        return !image                ? std::span<const std::byte>(kUnused)
               : image->holdsBytes() ? std::as_bytes(std::span(image->bytes))
                                     : std::as_bytes(std::span(image->floats));
    }
    /// The last one may be incomplete.
    size_t count() const { return (bytes().size() + kBytesOfTexelRow - 1) / kBytesOfTexelRow; }
};

inline size_t rowCount(std::span<const TexelRows> images) {
    size_t count = 0;
    for (const TexelRows& rows : images)
        count += rows.count();
    return count;
}

} // namespace calotype
