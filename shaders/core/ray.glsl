// Rays, and their origins, which are moved off a surface so that rays do not hit it again.
#ifndef CALOTYPE_CORE_RAY_GLSL
#define CALOTYPE_CORE_RAY_GLSL

#include "core/rounding.glsl"

/// Points origin + t direction with 0 < t < tMax; the direction may have any length.
struct Ray {
    vec3 origin;
    float tMax;
    vec3 direction;
};

/// The point moved off its surface, to the side that `ng` points to. `error` bounds the distance
/// along ng between `p` and the true surface; the second term is larger than the rounding of the
/// sum itself. There is no constant in metres: the offset scales with the scene.
vec3 offsetFromSurface(vec3 p, float error, vec3 ng) {
    return p + (ng * error + sign(ng) * abs(p) * kUnitRoundoff);
}

#endif
