#pragma once

#include <cstdint>
#include <numeric>

#include "settings/render_settings.h"
#include "shared/limits.h"

namespace calotype {

inline constexpr uint32_t kPixelsPerTile = shared::kTileSize * shared::kTileSize;

/// The number of tiles of shared::kTileSize pixels that cover this many pixels of a row or column.
inline uint32_t tilesAlong(uint32_t pixels) {
    return (pixels + shared::kTileSize - 1) / shared::kTileSize;
}

/// The number of tiles that cover the crop.
inline uint32_t countTiles(const Crop& crop) {
    return tilesAlong(crop.width) * tilesAlong(crop.height);
}

/// A stride coprime to the number of groups. llvmpipe gives each thread a contiguous part of a
/// dispatch, and neighbouring groups take about the same time; with this stride they are spread
/// evenly over the threads. Small enough for 32-bit products of the largest pictures.
inline uint32_t coprimeStride(uint32_t groupCount) {
    uint32_t stride = 61;
    while (std::gcd(stride, groupCount) != 1)
        --stride;
    return stride;
}

} // namespace calotype
