// What the host tells a dispatch of the path tracing kernel, and what it hears back.
#ifndef CALOTYPE_SHARED_RENDER_STRUCTS_H
#define CALOTYPE_SHARED_RENDER_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// Push constants. A dispatch renders `sampleEnd` samples of the block in every pixel of its tiles,
/// less those that the storage image already holds.
struct RenderParameters {
    uvec2 imageSize;  ///< of the whole film, pixels
    uvec2 cropOrigin; ///< first pixel of the storage image on the film
    uvec2 cropSize;   ///< of the storage image, pixels
    uint firstTile;   ///< in the order of `tileStride`
    uint tileCount;   ///< tiles of the whole storage image
    uint tileStride;  ///< coprime to tileCount: spreads neighbouring tiles over the threads
    uint firstSample; ///< absolute index of the block's first sample
    uint sampleEnd;   ///< samples of this block to have after the dispatch, at most
    uint seed;
    uint maxBounces;
    uint lightCount;
    uint iterationsBeforePause; ///< loop iterations after which a pixel takes up no new sample
    uint iterationsBeforeCut;   ///< and after which a path is ended, and counted
};

/// Sums over one dispatch, added to atomically, once per subgroup.
struct RenderCounters {
    uint rays;
    uint paths;
    uint nonFiniteSamples; ///< samples that came out NaN or infinite and were added as zero
    uint cutPaths;         ///< paths ended by the loop budget: their image is too dark
    uint unfinishedPixels; ///< pixels that ran out of loop budget before `sampleEnd`
    uint pad0;
    uint pad1;
    uint pad2;
};

CALOTYPE_END_SHARED

#ifdef __cplusplus
namespace calotype::gpu {
static_assert(sizeof(RenderParameters) == 64);
static_assert(sizeof(RenderCounters) == 32);
} // namespace calotype::gpu
#endif

#endif
