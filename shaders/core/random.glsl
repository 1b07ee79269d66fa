// Uniform random numbers without state: a hash of (pixel, sample, dimension, seed), so that the
// samples do not depend on tiles, passes or scheduling.
#ifndef CALOTYPE_CORE_RANDOM_GLSL
#define CALOTYPE_CORE_RANDOM_GLSL

/// What a path's random numbers depend on.
struct SampleId {
    uvec2 pixel; ///< on the whole film, below 65536 each
    uint sampleIndex;
    uint seed;
};

// Each dimension is four numbers. A path has the same dimensions in every scene, so that a feature
// that is left out does not change other numbers. The camera and each bounce have spare dimensions,
// so that a new use does not change the pictures of older scenes.
const uint kDimensionCamera = 0u;     ///< position in the pixel and on the lens
const uint kDimensionTime = 1u;       ///< within the shutter's opening; not used yet
const uint kDimensionWavelength = 2u; ///< not used yet
const uint kDimensionsBeforeBounces = 8u;
const uint kDimensionsPerBounce = 8u;
const uint kDimensionLight = 0u;          ///< choice of a light and a point on it
const uint kDimensionBsdf = 1u;           ///< direction of the next ray, choice of a lobe
const uint kDimensionAlpha = 2u;          ///< which surfaces up to the next event let light through
const uint kDimensionMediumDistance = 3u; ///< to the next event in a medium; not used yet
const uint kDimensionMediumPhase = 4u;    ///< direction after an event in a medium; not used yet

uint bounceDimension(uint bounce, uint offset) {
    return kDimensionsBeforeBounces + kDimensionsPerBounce * bounce + offset;
}

/// PCG hash of four words (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering").
uvec4 pcg4d(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

/// Uniform random numbers are multiples of 1 / 2^24.
const float kUnitSteps = 16777216.0;

/// The upper 24 bits, times 2^-24: uniform in [0, 1 - 2^-24], every value exact.
vec4 unitFloats(uvec4 bits) { return vec4(bits >> 8u) * (1.0 / kUnitSteps); }

/// Four independent numbers in [0, 1).
vec4 uniformRandom(SampleId id, uint dimension) {
    uint pixel = id.pixel.x | (id.pixel.y << 16u);
    return unitFloats(pcg4d(uvec4(pixel, id.sampleIndex, dimension, id.seed)));
}

/// One number in [0, 1), a different one for each `item` of a dimension.
float uniformRandomOf(SampleId id, uint dimension, uint item) {
    uint pixel = id.pixel.x | (id.pixel.y << 16u);
    uvec4 bits = pcg4d(uvec4(pixel, id.sampleIndex, dimension, id.seed));
    return unitFloats(pcg4d(uvec4(bits.xyz, item))).x;
}

#endif
