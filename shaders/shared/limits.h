// Constants that host and kernels share.
#ifndef CALOTYPE_SHARED_LIMITS_H
#define CALOTYPE_SHARED_LIMITS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// Samples of consecutive absolute indices, summed in one storage image for the film.
CALOTYPE_CONSTANT uint kSamplesPerBlock = 16;

/// A block counts a pixel's samples in one float: 1 for each, and this much more for each that
/// shows the background where it is hidden from the camera. So the whole part is the number of
/// samples; all sums are exact.
CALOTYPE_CONSTANT float kHiddenSample = 1.0f / 32.0f;

/// Independent randomisations; blocks belong to them in turn.
CALOTYPE_CONSTANT uint kReplicas = 8;

/// Side in pixels of the square tile that one workgroup renders.
CALOTYPE_CONSTANT uint kTileSize = 16;

/// Tiles of one dispatch at most: every device allows so many workgroups.
CALOTYPE_CONSTANT uint kMostTilesPerDispatch = 65535;

/// Depth of the deepest node of a BVH below its root; limits the traversal stack.
CALOTYPE_CONSTANT uint kMaxBvhDepth = 32;

/// Places of nodes have 24 bits: accel/wide_node.glsl stores eight other bits in the same word.
CALOTYPE_CONSTANT uint kMostNodes = 1u << 24u;

/// The largest primitive has eight rows at most, and rows are numbered by 31 bits.
CALOTYPE_CONSTANT uint kMostPrimitives = 1u << 28u;

/// Mirrors and clear surfaces that the search for a pixel's features follows a ray through.
CALOTYPE_CONSTANT uint kMostSpecularEvents = 8;

/// Scattering events of a path before it may end by roulette, and the throughput below which it
/// may (docs/models.md, "Russian roulette").
CALOTYPE_CONSTANT uint kEventsBeforeRoulette = 3;
CALOTYPE_CONSTANT float kRouletteThroughput = 0.25f;

/// Steps of the table of the film filter's quantiles.
CALOTYPE_CONSTANT uint kFilterSteps = 1023;

/// GGX lobes of a smaller alpha (roughness below 0.01) are mirrors. No unit: the tangent of a
/// lobe's half width. Rounding rotates a half vector by about 4e-7 radians, 0.4 % of this width,
/// which changes D by less than 2 %; float cannot represent narrower lobes.
CALOTYPE_CONSTANT float kMirrorAlpha = 1e-4f;

CALOTYPE_END_SHARED

#endif
