// The surface that a pixel shows: what its ray through the middle meets first.
#ifndef CALOTYPE_PATH_FIRST_HIT_GLSL
#define CALOTYPE_PATH_FIRST_HIT_GLSL

#include "lights/light.glsl"
#include "path/camera.glsl"
#include "path/visibility.glsl"
#include "shared/render_structs.h"

/// Surfaces that a ray passes through, at most, lest a deep stack of them takes long.
const uint kMostPassedSurfaces = 1024u;

/// True where the pixel shows what lies behind: at lights hidden from the camera, and where less
/// than half of the light meets the surface.
bool isSeenThrough(Interaction surface) {
    bool seenThrough = isHiddenFromCamera(surface.light);
    if (hasAlpha && isTransparent(surface.material))
        seenThrough = seenThrough || alphaAt(materialOf(surface), surface.coordinates.uv) < 0.5;
    return seenThrough;
}

FirstHitRecord recordOf(Interaction surface, Camera camera, vec3 wo) {
    SurfaceParameters parameters = surfaceParameters(materialOf(surface), surface);
    float side = dot(wo, surface.ng) >= 0.0 ? 1.0 : -1.0;
    FirstHitRecord record;
    record.albedo = surfaceAlbedo(parameters);
    record.depth = dot(surface.position - camera.position, camera.forward);
    record.normal = side * surface.ns;
    record.primitive = surface.id;
    record.position = surface.position;
    record.isCut = 0u;
    record.uv = hasTextures ? surface.coordinates.uv : vec2(0.0);
    record.pad0 = 0u;
    record.pad1 = 0u;
    return record;
}

FirstHitRecord recordOfNothing() {
    return FirstHitRecord(vec3(0.0), 0.0, vec3(0.0), kNone, vec3(0.0), 0u, vec2(0.0), 0u, 0u);
}

/// What the ray through the pixel's middle, from the lens's, meets first. Where it has passed
/// through kMostPassedSurfaces, or taken `mostIterations` of traverse, what comes next counts as
/// opaque.
FirstHitRecord firstHit(Camera camera, uvec2 pixel, uvec2 imageSize, uint mostIterations) {
    Ray ray = cameraRay(camera, vec2(pixel) + 0.5, imageSize, vec2(0.0));
    FirstHitRecord record = recordOfNothing();
    uint iterations = 0u;
    uint passed = 0u;
    bool goesOn;
    do {
        Hit hit = intersectClosest(ray, iterations);
        goesOn = false;
        if (hit.primitive != kNone) {
            Interaction surface = interactionAt(hit, ray);
            bool seenThrough = isSeenThrough(surface);
            bool mayGoOn = passed < kMostPassedSurfaces && iterations < mostIterations;
            goesOn = seenThrough && mayGoOn;
            ray.origin = goesOn ? pointBeyond(surface, ray.direction) : ray.origin;
            if (!goesOn) {
                record = recordOf(surface, camera, -ray.direction);
                record.isCut = seenThrough ? 1u : 0u;
            }
        }
        passed++;
        iterations++;
    } while (goesOn);
    return record;
}

#endif
