// Going on behind a surface that lets light through.
#ifndef CALOTYPE_PATH_VISIBILITY_GLSL
#define CALOTYPE_PATH_VISIBILITY_GLSL

#include "scene/surface.glsl"

/// The point from which a ray goes on that passed through the surface.
vec3 pointBeyond(Interaction surface, vec3 direction) {
    vec3 beyond = dot(direction, surface.ng) < 0.0 ? -surface.ng : surface.ng;
    return offsetFromSurface(surface.position, surface.error, beyond);
}

/// What is left of a ray that passed through the surface. A ray without an end stays without.
Ray rayBeyond(Interaction surface, Ray ray) {
    vec3 origin = pointBeyond(surface, ray.direction);
    vec3 end = ray.origin + ray.tMax * ray.direction;
    float tMax = ray.tMax < kFar ? dot(end - origin, ray.direction) : kFar;
    return Ray(origin, tMax, ray.direction);
}

#endif
