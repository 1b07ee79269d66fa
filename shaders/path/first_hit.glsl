// The surface that a pixel shows: what its ray through the middle meets first.
#ifndef CALOTYPE_PATH_FIRST_HIT_GLSL
#define CALOTYPE_PATH_FIRST_HIT_GLSL

#include "lights/light.glsl"
#include "path/camera.glsl"
#include "path/visibility.glsl"
#include "shared/layers.h"
#include "shared/render_structs.h"

/// The most surfaces that a ray passes through, so that a deep stack of them does not take long.
const uint kMostPassedSurfaces = 1024u;

/// True where the pixel shows what lies behind: at lights hidden from the camera, and where less
/// than half of the light meets the surface.
bool isSeenThrough(Interaction surface) {
    bool seenThrough = isHiddenFromCamera(surface.light);
    if (hasAlpha && isTransparent(surface.material))
        seenThrough = seenThrough || alphaAt(materialOf(surface), surface.coordinates.uv) < 0.5;
    return seenThrough;
}

FirstHit firstHitOn(Interaction surface, Camera camera, vec3 wo) {
    SurfaceParameters parameters = surfaceParameters(materialOf(surface), surface);
    float side = dot(wo, surface.ng) >= 0.0 ? 1.0 : -1.0;
    FirstHit hit;
    hit.albedo = surfaceAlbedo(parameters);
    hit.depth = dot(surface.position - camera.position, camera.forward);
    hit.normal = side * surface.ns;
    hit.primitive = surface.id;
    hit.position = surface.position;
    hit.uv = hasTextures ? surface.coordinates.uv : vec2(0.0);
    return hit;
}

/// All fields are 0, but for the primitive.
FirstHit firstHitOnNothing() {
    FirstHit hit;
#define CALOTYPE_CLEAR(name, type, nothing, channels, help) hit.name = type(0);
    CALOTYPE_FIRST_HIT_LAYERS(CALOTYPE_CLEAR)
#undef CALOTYPE_CLEAR
    hit.primitive = kNone;
    return hit;
}

/// What the ray through the pixel's middle, from the lens's, meets first. Where it has passed
/// through kMostPassedSurfaces, or taken `mostIterations` of traverse, what comes next counts as
/// opaque.
FirstHitRecord firstHit(Camera camera, uvec2 pixel, uvec2 imageSize, uint mostIterations) {
    Ray ray = cameraRay(camera, vec2(pixel) + 0.5, imageSize, vec2(0.0));
    FirstHitRecord record = FirstHitRecord(firstHitOnNothing(), 0u);
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
                record.hit = firstHitOn(surface, camera, -ray.direction);
                record.isCut = seenThrough ? 1u : 0u;
            }
        }
        passed++;
        iterations++;
    } while (goesOn);
    return record;
}

#endif
