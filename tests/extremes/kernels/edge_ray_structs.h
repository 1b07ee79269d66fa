// What the kernel of rays aimed at edges takes and gives back, in rows of 16 bytes.
#ifndef CALOTYPE_EDGE_RAY_STRUCTS_H
#define CALOTYPE_EDGE_RAY_STRUCTS_H

#include "shared/bindings.h"

CALOTYPE_BEGIN_SHARED

CALOTYPE_CONSTANT uint kBindingEdgeBatches = kBindingCount;
CALOTYPE_CONSTANT uint kBindingEdgeEscapes = kBindingCount + 1;

/// Rays that one invocation casts: few enough that their traversals stay below the 65,535 loop
/// iterations that llvmpipe grants.
CALOTYPE_CONSTANT uint kRaysPerEdgeBatch = 16;

struct EdgeBatch {
    vec3 center;     ///< from which all of the mesh is seen, in the packed scene
    float innermost; ///< origins lie up to this share of the way from there to the surface
    uint triangleCount;
    uint seed;
    uint hasUnitRays; ///< 1: directions of unit length, as the renderer's; else they end at the aim
    uint pad0;
};

struct EdgeEscapes {
    vec3 origin; ///< of the last ray that escaped
    uint count;
    vec3 direction;
    uint iterations; ///< of all traversals
};

CALOTYPE_END_SHARED

#endif
