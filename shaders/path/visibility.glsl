// How a ray continues behind a surface that light passes through.
#ifndef CALOTYPE_PATH_VISIBILITY_GLSL
#define CALOTYPE_PATH_VISIBILITY_GLSL

#include "core/random.glsl"
#include "scene/surface.glsl"

/// True if a ray that comes to a surface after `bounce` events passes through it, at random by its
/// alpha. A ray that enters and leaves the same primitive hits it twice, so each side has its own
/// random numbers.
bool letsPass(SampleId id, uint bounce, Interaction surface, float alpha, vec3 direction) {
    if (!hasAlpha || !isTransparent(surface.material))
        return false;
    uint fromBehind = dot(direction, surface.ng) > 0.0 ? 1u : 0u;
    return uniformRandomOf(id, bounceDimension(bounce, kDimensionAlpha),
                           2u * surface.id + fromBehind) >= alpha;
}

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
