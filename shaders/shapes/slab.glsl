// The part of a line between two parallel planes.
#ifndef CALOTYPE_SHAPES_SLAB_GLSL
#define CALOTYPE_SHAPES_SLAB_GLSL

#include "core/constants.glsl"

/// 1 / x, with |x| at least 1e-18, so that no product with a difference of coordinates is NaN.
float safeReciprocal(float x) { return 1.0 / (abs(x) < 1e-18 ? (x < 0.0 ? -1e-18 : 1e-18) : x); }

vec3 safeReciprocal(vec3 v) {
    return vec3(safeReciprocal(v.x), safeReciprocal(v.y), safeReciprocal(v.z));
}

/// Parameter interval in which lower <= y + t dy <= upper. An origin within `error` of a plane
/// counts as on it: t = 0 there, which no ray accepts.
vec2 slabInterval(float y, float dy, float lower, float upper, float error) {
    float inverse = safeReciprocal(dy);
    float toLower = lower - y;
    float toUpper = upper - y;
    float tLower = abs(toLower) <= error ? 0.0 : toLower * inverse;
    float tUpper = abs(toUpper) <= error ? 0.0 : toUpper * inverse;
    return vec2(min(tLower, tUpper), max(tLower, tUpper));
}

/// First crossing of the boundary of a convex solid along a ray, from the interval in which its
/// line is inside: the entry if it is ahead, else the exit; kFar if neither is.
float firstCrossing(vec2 interval) {
    float t = interval.x > 0.0 ? interval.x : interval.y;
    return interval.x <= interval.y && t > 0.0 ? t : kFar;
}

#endif
