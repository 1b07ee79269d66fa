// A ray in a quadric's own frame.
#ifndef CALOTYPE_SHAPES_LOCAL_RAY_GLSL
#define CALOTYPE_SHAPES_LOCAL_RAY_GLSL

#include "core/rounding.glsl"

/// `error` bounds the rounding of each component of the origin: three products and two sums, after
/// one difference, so gamma_4 of the terms' absolute values. It is zero where these are: in an
/// unrotated frame each component's error is relative to that component alone.
struct LocalRay {
    vec3 origin;
    vec3 direction;
    vec3 error;
};

LocalRay localRay(vec3 origin, vec3 direction, vec3 center, mat3 worldFromObject) {
    vec3 offset = origin - center;
    LocalRay ray;
    ray.origin = offset * worldFromObject;
    ray.direction = direction * worldFromObject;
    mat3 magnitude =
        mat3(abs(worldFromObject[0]), abs(worldFromObject[1]), abs(worldFromObject[2]));
    ray.error = GAMMA(4.0) * (abs(offset) * magnitude);
    return ray;
}

#endif
