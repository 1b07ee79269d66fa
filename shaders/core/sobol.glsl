// Numbers that fill the square more evenly than chance: the first two dimensions of Sobol's
// sequence, Owen-scrambled, in an order of their own for each use (Burley 2020, "Practical
// Hash-based Owen Scrambling").
//
// Of 2^k samples of a replica in a row, from a multiple of 2^k on, each elementary interval of area
// 2^-k holds exactly one: every strip, every column, every square. Each point alone is uniform, so
// estimates stay unbiased; points of different uses, and of different replicas, are independent.
#ifndef CALOTYPE_CORE_SOBOL_GLSL
#define CALOTYPE_CORE_SOBOL_GLSL

#include "core/random.glsl"
#include "shared/limits.h"

/// The second dimension of Sobol's sequence, its first bit the lowest: Pascal's triangle modulo 2
/// times the index, which is the Kronecker power of its 2 x 2 corner.
uint secondSobol(uint index) {
    index ^= index >> 16u;
    index ^= index >> 8u & 0x00FF00FFu;
    index ^= index >> 4u & 0x0F0F0F0Fu;
    index ^= index >> 2u & 0x33333333u;
    index ^= index >> 1u & 0x55555555u;
    return index;
}

/// A permutation in which bits depend on lower ones only: Owen's scrambling, the first bit of a
/// fraction lowest (Laine and Karras 2011, "Stratified Sampling for Stochastic Transparency", with
/// the constants of Vegdahl 2021, "Building a Better LK Hash").
uint scrambleFromBelow(uint bits, uint seed) {
    bits ^= bits * 0x3D20ADEAu;
    bits += seed;
    bits *= (seed >> 16u) | 1u;
    bits ^= bits * 0x05526C56u;
    bits ^= bits * 0x53A22864u;
    return bits;
}

/// One point of the unit square for each `use`. Blocks of samples belong to replicas in turn, whose
/// points are independent of each other's.
vec2 sobolPoint(SampleId id, uint use) {
    const uint kUseOfPoints = 0x80000000u; // apart from what is hashed by sample
    uint block = id.sampleIndex / kSamplesPerBlock;
    uint index = block / kReplicas * kSamplesPerBlock + id.sampleIndex % kSamplesPerBlock;
    uvec4 seeds = pcg4d(
        uvec4(id.pixel.x | (id.pixel.y << 16u), block % kReplicas, kUseOfPoints + use, id.seed));
    uint order = bitfieldReverse(scrambleFromBelow(bitfieldReverse(index), seeds.x));
    uint x = bitfieldReverse(scrambleFromBelow(order, seeds.y));
    uint y = bitfieldReverse(scrambleFromBelow(secondSobol(order), seeds.z));
    return unitFloats(uvec4(x, y, 0u, 0u)).xy;
}

/// In place of uniformRandom: two points.
vec4 sobolRandom(SampleId id, uint dimension) {
    return vec4(sobolPoint(id, 2u * dimension), sobolPoint(id, 2u * dimension + 1u));
}

#endif
