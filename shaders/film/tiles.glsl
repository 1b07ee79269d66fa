// Which pixel an invocation owns.
#ifndef CALOTYPE_FILM_TILES_GLSL
#define CALOTYPE_FILM_TILES_GLSL

#include "shared/limits.h"

/// The even bits of x, packed: half of a Morton code.
uint evenBits(uint x) {
    x &= 0x55555555u;
    x = (x ^ (x >> 1u)) & 0x33333333u;
    x = (x ^ (x >> 2u)) & 0x0F0F0F0Fu;
    return x;
}

/// The first pixel of a tile. The last tiles extend beyond the picture.
uvec2 cornerOfTile(uint tile, uvec2 imageSize) {
    uint tilesPerRow = (imageSize.x + kTileSize - 1u) / kTileSize;
    return kTileSize * uvec2(tile % tilesPerRow, tile / tilesPerRow);
}

/// A pixel of a tile by its number, along a Z curve, so that the rays of a subgroup stay close.
uvec2 pixelInTile(uvec2 corner, uint item) {
    return corner + uvec2(evenBits(item), evenBits(item >> 1u));
}

#endif
