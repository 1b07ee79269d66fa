// The position of a sample in and around its pixel. It is distributed as the film's filter, so that
// a sample belongs to one pixel and has weight one (Ernst, Stamminger and Greiner 2006, "Filter
// Importance Sampling").
#ifndef CALOTYPE_FILM_FILM_FILTER_GLSL
#define CALOTYPE_FILM_FILM_FILTER_GLSL

#include "buffers/packed_scene.glsl"
#include "config/features.glsl"
#include "shared/limits.h"

/// Distance from the pixel's centre along one axis. The table has the filter's quantiles in equal
/// steps, from its centre outwards, and is interpolated linearly.
float sampleFilterTable(float u) {
    float step = abs(2.0 * u - 1.0) * float(kFilterSteps);
    uint index = min(uint(step), kFilterSteps - 1u);
    float f = step - float(index);
    vec2 ends = loadFilterStep(index).quantiles;
    float x = (1.0 - f) * ends.x + f * ends.y;
    return u < 0.5 ? -x : x;
}

/// A position relative to the pixel's top left corner, in pixels.
vec2 sampleFilm(Camera camera, vec2 u) {
    if (hasFilter && camera.filterIsBox == 0u)
        return 0.5 + vec2(sampleFilterTable(u.x), sampleFilterTable(u.y));
    return u;
}

#endif
