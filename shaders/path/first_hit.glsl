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

/// The search for what a pixel shows.
struct FirstHitSearch {
    Ray ray;
    uint passed; ///< surfaces that the ray has passed through
    bool goesOn;
    FirstHitRecord record;
};

/// The ray goes through the middles of the pixel and of the lens.
FirstHitSearch startFirstHit(Camera camera, uvec2 pixel, uvec2 imageSize) {
    Ray ray = cameraRay(camera, vec2(pixel) + 0.5, imageSize, vec2(0.0));
    return FirstHitSearch(ray, 0u, true, FirstHitRecord(firstHitOnNothing(), 0u));
}

/// Takes in what the ray met. Where it has passed through kMostPassedSurfaces, or `mayGoOn` is
/// false, the search ends there, and its record says that it was cut.
void extendFirstHit(inout FirstHitSearch search, Hit hit, Camera camera, bool mayGoOn) {
    search.goesOn = false;
    if (hit.primitive != kNone) {
        Interaction surface = interactionAt(hit, search.ray);
        bool seenThrough = isSeenThrough(surface);
        mayGoOn = mayGoOn && search.passed < kMostPassedSurfaces;
        search.goesOn = seenThrough && mayGoOn;
        if (search.goesOn) {
            search.ray.origin = pointBeyond(surface, search.ray.direction);
        } else {
            search.record.hit = firstHitOn(surface, camera, -search.ray.direction);
            search.record.isCut = seenThrough ? 1u : 0u;
        }
    }
    search.passed++;
}

#endif
