// Points that fill the unit square more evenly than random ones: the first two dimensions of
// Sobol's sequence, Owen-scrambled, in a different order for each use (Burley 2020, "Practical
// Hash-based Owen Scrambling").
//
// Take 2^k consecutive samples of a replica that start at a multiple of 2^k: each elementary
// interval of area 2^-k (strips, columns, squares) contains exactly one of them. Each single point
// is uniform, so estimates are unbiased; points of different uses or replicas are independent.
#ifndef CALOTYPE_CORE_SOBOL_GLSL
#define CALOTYPE_CORE_SOBOL_GLSL

#include "core/random.glsl"
#include "shared/limits.h"

/// The second dimension of Sobol's sequence, first bit lowest: Pascal's triangle modulo 2 times the
/// index. That matrix is the Kronecker power of its 2 x 2 corner.
uint secondSobol(uint index) {
    index ^= index >> 16u;
    index ^= index >> 8u & 0x00FF00FFu;
    index ^= index >> 4u & 0x0F0F0F0Fu;
    index ^= index >> 2u & 0x33333333u;
    index ^= index >> 1u & 0x55555555u;
    return index;
}

/// A permutation in which each bit depends on lower bits only: Owen's scrambling of a fraction
/// whose first bit is lowest (Laine and Karras 2011, "Stratified Sampling for Stochastic
/// Transparency", with the constants of Vegdahl 2021, "Building a Better LK Hash").
uint scrambleFromBelow(uint bits, uint seed) {
    bits ^= bits * 0x3D20ADEAu;
    bits += seed;
    bits *= (seed >> 16u) | 1u;
    bits ^= bits * 0x05526C56u;
    bits ^= bits * 0x53A22864u;
    return bits;
}

/// One point of the unit square for each `use`. Blocks of samples belong to replicas in turn; the
/// points of different replicas are independent.
vec2 sobolPoint(SampleId id, uint use) {
    const uint kUseOfPoints = 0x80000000u; // distinct from what is hashed by sample
    uint block = id.sampleIndex / kSamplesPerBlock;
    uint index = block / kReplicas * kSamplesPerBlock + id.sampleIndex % kSamplesPerBlock;
    uvec4 seeds = pcg4d(
        uvec4(id.pixel.x | (id.pixel.y << 16u), block % kReplicas, kUseOfPoints + use, id.seed));
    uint order = bitfieldReverse(scrambleFromBelow(bitfieldReverse(index), seeds.x));
    uint x = bitfieldReverse(scrambleFromBelow(order, seeds.y));
    uint y = bitfieldReverse(scrambleFromBelow(secondSobol(order), seeds.z));
    return unitFloats(uvec4(x, y, 0u, 0u)).xy;
}

/// Replaces uniformRandom: two points.
vec4 sobolRandom(SampleId id, uint dimension) {
    return vec4(sobolPoint(id, 2u * dimension), sobolPoint(id, 2u * dimension + 1u));
}

#endif
