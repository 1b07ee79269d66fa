// Sizes on which host and kernels must agree.
#ifndef CALOTYPE_SHARED_LIMITS_H
#define CALOTYPE_SHARED_LIMITS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// Consecutive absolute sample indices summed in one storage image before the film takes them.
CALOTYPE_CONSTANT uint kSamplesPerBlock = 16;

/// Independent randomisations that blocks belong to in turn.
CALOTYPE_CONSTANT uint kReplicas = 8;

/// Pixels on a side of the square tile that one workgroup owns.
CALOTYPE_CONSTANT uint kTileSize = 16;

/// Tiles that one dispatch renders, which any device takes as workgroups.
CALOTYPE_CONSTANT uint kMostTilesPerDispatch = 65535;

/// Deepest node of a BVH below its root, which bounds the traversal stack.
CALOTYPE_CONSTANT uint kMaxBvhDepth = 32;

/// Places of nodes have 24 bits: accel/wide_node.glsl keeps eight others in the same word.
CALOTYPE_CONSTANT uint kMostNodes = 1u << 24u;

/// Rows of the largest primitive, eight at most, are numbered by 31 bits.
CALOTYPE_CONSTANT uint kMostPrimitives = 1u << 28u;

/// Scattering events of a path before it may end by roulette, and the throughput below which it
/// may (docs/models.md, "Russian roulette").
CALOTYPE_CONSTANT uint kEventsBeforeRoulette = 3;
CALOTYPE_CONSTANT float kRouletteThroughput = 0.25f;

/// Steps of the table of the film filter's quantiles.
CALOTYPE_CONSTANT uint kFilterSteps = 1023;

/// GGX lobes of a smaller alpha (roughness below 0.01) are mirrors. No unit: the tangent of a
/// lobe's half width. Rounding turns a half vector by some 4e-7 radians, 0.4 % of this one, which
/// moves D by less than 2 %; float resolves no narrower lobes.
CALOTYPE_CONSTANT float kMirrorAlpha = 1e-4f;

CALOTYPE_END_SHARED

#endif
