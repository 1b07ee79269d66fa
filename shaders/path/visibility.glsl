// How a ray continues behind a surface that light passes through.
#ifndef CALOTYPE_PATH_VISIBILITY_GLSL
#define CALOTYPE_PATH_VISIBILITY_GLSL

#include "scene/surface.glsl"

/// The origin of a ray that continues after it passed through the surface.
vec3 pointBeyond(Interaction surface, vec3 direction) {
    vec3 beyond = dot(direction, surface.ng) < 0.0 ? -surface.ng : surface.ng;
    return offsetFromSurface(surface.position, surface.error, beyond);
}

/// The rest of a ray that passed through the surface. An infinite ray stays infinite.
Ray rayBeyond(Interaction surface, Ray ray) {
    vec3 origin = pointBeyond(surface, ray.direction);
    vec3 end = ray.origin + ray.tMax * ray.direction;
    float tMax = ray.tMax < kFar ? dot(end - origin, ray.direction) : kFar;
    return Ray(origin, tMax, ray.direction);
}

#endif
