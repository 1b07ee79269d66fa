// The inputs of a dispatch of a rendering kernel, and its results.
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
    uint firstTile;   ///< in the list of tiles
    uint firstSample; ///< absolute index of the block's first sample
    uint sampleEnd;   ///< samples of this block to have after the dispatch, at most
    uint seed;
    uint maxBounces;
    uint lightCount;
    uint iterationBudget; ///< loop iterations after which a subgroup puts its paths down
    float indirectClamp;  ///< most of one contribution of light scattered twice or more, W/(m^2 sr)
    uint backgroundLight; ///< the light that rays find which meet no surface, or kNone
    uint pad0;
};

/// Sums over one dispatch, added to atomically, once per subgroup.
struct RenderCounters {
    uint rays;
    uint paths;
    uint nonFiniteSamples; ///< samples that came out NaN or infinite and were added as zero
    uint cutPaths;         ///< paths of a ray that takes a whole budget: their image is too dark
    uint unfinishedPixels; ///< pixels put down before `sampleEnd`, for the next dispatch
    uint pad0;
    uint pad1;
    uint pad2;
};

/// Where a workgroup put a task of a lane down, for the next dispatch of the same tiles.
struct ParkedPath {
    vec3 rayOrigin;
    float rayTMax;
    vec3 rayDirection;
    uint target;
    vec3 vertex;
    uint bounce;
    vec3 throughput;
    float bsdfPdf;
    vec3 radiance;
    float etaScale;
    vec3 arriving;
    uint item; ///< the task's pixel, in the order of the tile; kTaskHasPath, kTaskIsShadowed
    vec3 direction;
    uint nextItem; ///< the tile's next pixel; 0 where the tile is to be begun anew
};

CALOTYPE_CONSTANT uint kTaskHasPath = 0x80000000u;
CALOTYPE_CONSTANT uint kTaskIsShadowed = 0x40000000u;

/// Push constants. A dispatch finds the first hits of the pixels of a run of tiles.
struct FirstHitParameters {
    uvec2 imageSize;  ///< of the whole film, pixels
    uvec2 cropOrigin; ///< first pixel of the picture on the film
    uvec2 cropSize;   ///< of the picture, pixels
    uint firstTile;
    uint iterationsBeforeCut; ///< loop iterations after which a ray passes through nothing more
};

CALOTYPE_END_SHARED

#ifdef __cplusplus
namespace calotype::shared {
static_assert(sizeof(RenderParameters) == 64);
static_assert(sizeof(RenderCounters) == 32);
static_assert(sizeof(ParkedPath) == 112);
static_assert(sizeof(FirstHitParameters) == 32);
} // namespace calotype::shared
#endif

#endif
