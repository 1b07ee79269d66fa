// What of the light comes through between two points.
#ifndef CALOTYPE_PATH_VISIBILITY_GLSL
#define CALOTYPE_PATH_VISIBILITY_GLSL

#include "scene/surface.glsl"

struct PathCost {
    uint rays;
    uint iterations;       ///< see traverse
    uint iterationsToLast; ///< beyond which no ray is sent on through transparent surfaces
    bool cut;              ///< one was not
};

/// The point from which a ray goes on that passed through the surface.
vec3 pointBeyond(Interaction surface, vec3 direction) {
    vec3 beyond = dot(direction, surface.ng) < 0.0 ? -surface.ng : surface.ng;
    return offsetFromSurface(surface.position, surface.error, beyond);
}

/// The share of light that reaches the ray's origin from its end: 0 behind anything opaque but the
/// primitive `target`, else the product of 1 - alpha over all that lies between.
float transmittance(Ray ray, uint target, inout PathCost cost) {
    vec3 end = ray.origin + ray.tMax * ray.direction;
    float share = 1.0;
    bool goesOn;
    do {
        cost.rays++;
        Hit hit = intersectAny(ray, target, cost.iterations);
        goesOn = hit.primitive != kNone && isTransparent(hit);
        if (!goesOn)
            share = hit.primitive == kNone ? share : 0.0;
        if (goesOn) {
            Interaction surface = interactionAt(hit, ray);
            share *= 1.0 - alphaAt(materialOf(surface), surface.coordinates.uv);
            ray.origin = pointBeyond(surface, ray.direction);
            ray.tMax = ray.tMax < kFar ? dot(end - ray.origin, ray.direction) : kFar;
            goesOn = share > 0.0;
        }
        if (goesOn && cost.iterations > cost.iterationsToLast) {
            cost.cut = true;
            share = 0.0;
            goesOn = false;
        }
        cost.iterations++;
    } while (goesOn);
    return share;
}

#endif
