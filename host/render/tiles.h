#pragma once

#include <cstdint>

#include "render/render_settings.h"
#include "shared/limits.h"

namespace calotype {

/// Square tiles of gpu::kTileSize pixels a side that cover so many pixels of a row or column.
inline uint32_t tilesAlong(uint32_t pixels) {
    return (pixels + gpu::kTileSize - 1) / gpu::kTileSize;
}

/// Those that cover the crop, counted row by row.
inline uint32_t countTiles(const Crop& crop) {
    return tilesAlong(crop.width) * tilesAlong(crop.height);
}

} // namespace calotype
