// How much one pixel counts for another in the statistical denoiser (docs/models.md, "The
// statistical denoiser").
#ifndef CALOTYPE_FILM_SIMILARITY_GLSL
#define CALOTYPE_FILM_SIMILARITY_GLSL

#include "shared/denoise_structs.h"

/// Whether the difference is within the noise in every channel.
bool isWithinNoise(NoisyColor a, NoisyColor b, float squaredBound) {
    vec3 difference = a.mean - b.mean;
    return all(lessThanEqual(difference * difference, squaredBound * (a.variance + b.variance)));
}

/// The weight of a pixel for another, in [0, 1], if the noise allows it. `offset` is their distance
/// in pixels.
float similarityOf(PixelGuides a, PixelGuides b, vec2 offset) {
    vec2 distance = offset * (1.0 / kDistanceDeviation);
    vec3 albedo = (a.albedo - b.albedo) * (1.0 / kAlbedoDeviation);
    vec3 normal = (a.normal - b.normal) * (1.0 / kNormalDeviation);
    return exp(-0.5 * (dot(distance, distance) + dot(albedo, albedo) + dot(normal, normal)));
}

#endif
