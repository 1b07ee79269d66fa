// Lists of rays, which are traced without any shading.
#ifndef CALOTYPE_SHARED_RAY_STRUCTS_H
#define CALOTYPE_SHARED_RAY_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

struct ListedRay {
    vec3 origin; ///< metres from the packed scene's origin
    float tMax;  ///< metres; 0 where a pixel has no such ray
    vec3 direction;
    uint target; ///< the primitive that it passes by, or kNone
};

/// What a ray met: the closest, or where any hit would do, some.
struct ListedHit {
    float t;        ///< metres; the ray's tMax where it met nothing
    uint primitive; ///< as kQuadricBit says, or kNone
};

/// Push constants of both kernels, the one that lists rays and the one that traces them.
struct RayListParameters {
    uvec2 imageSize; ///< pixels
    uint firstGroup; ///< tiles of the picture, or kRaysPerGroup consecutive rays
    uint groupCount;
    uint groupStride; ///< as RenderParameters::tileStride
    uint rayCount;
    uint isShadow; ///< 1 for rays to lights, from what primary rays meet
    uint bounces;  ///< else: scattering events before the ray
    uint seed;
    uint lightCount;
    uint iterationBudget;
    uint pad0;
};

CALOTYPE_CONSTANT uint kRaysPerGroup = 256;

CALOTYPE_END_SHARED

#ifdef __cplusplus
namespace calotype::shared {
static_assert(sizeof(ListedRay) == 32);
static_assert(sizeof(ListedHit) == 8);
static_assert(sizeof(RayListParameters) == 48);
} // namespace calotype::shared
#endif

#endif
