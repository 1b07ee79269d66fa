#pragma once

#include <cstdint>
#include <numeric>

#include "settings/render_settings.h"
#include "shared/limits.h"

namespace calotype {

inline constexpr uint32_t kPixelsPerTile = shared::kTileSize * shared::kTileSize;

/// Square tiles of shared::kTileSize pixels a side that cover so many pixels of a row or column.
inline uint32_t tilesAlong(uint32_t pixels) {
    return (pixels + shared::kTileSize - 1) / shared::kTileSize;
}

/// Those that cover the crop, counted row by row.
inline uint32_t countTiles(const Crop& crop) {
    return tilesAlong(crop.width) * tilesAlong(crop.height);
}

/// llvmpipe gives each thread a contiguous part of a dispatch, so neighbouring groups, which take
/// about as long, are dealt out evenly by striding through all with a number coprime to theirs.
/// Small enough for 32-bit products of the largest pictures.
inline uint32_t coprimeStride(uint32_t groupCount) {
    uint32_t stride = 61;
    while (std::gcd(stride, groupCount) != 1)
        --stride;
    return stride;
}

} // namespace calotype
