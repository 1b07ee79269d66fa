// The surface that a pixel shows: the first hit of the ray through its centre.
#ifndef CALOTYPE_PATH_FIRST_HIT_GLSL
#define CALOTYPE_PATH_FIRST_HIT_GLSL

#include "lights/light.glsl"
#include "path/camera.glsl"
#include "path/visibility.glsl"
#include "shared/layers.h"
#include "shared/render_structs.h"

/// A ray passes through this many surfaces at most, to bound the time that a deep stack takes.
const uint kMostPassedSurfaces = 1024u;

/// True if the pixel shows what is behind: at lights hidden from the camera, and if alpha is below
/// 1/2.
bool isSeenThrough(Interaction surface) {
    bool seenThrough = isHiddenFromCamera(surface.light);
    if (hasAlpha && isTransparent(surface.material))
        seenThrough = seenThrough || alphaAt(materialOf(surface), surface.coordinates.uv) < 0.5;
    return seenThrough;
}

FirstHit firstHitOn(Interaction surface, Camera camera, vec3 wo) {
    Material material = materialOf(surface);
    applyTextures(material, surface);
    float side = dot(wo, surface.ng) >= 0.0 ? 1.0 : -1.0;
    FirstHit hit;
    hit.albedo = surfaceAlbedo(material);
    hit.depth = dot(surface.position - camera.position, camera.forward);
    hit.normal = side * surface.ns;
    hit.primitive = surface.id;
    hit.position = surface.position;
    hit.uv = hasTextures ? surface.coordinates.uv : vec2(0.0);
    return hit;
}

/// All fields are 0, except the primitive.
FirstHit firstHitOnNothing() {
    FirstHit hit;
#define CALOTYPE_CLEAR(name, type, nothing, channels, help) hit.name = type(0);
    CALOTYPE_FIRST_HIT_LAYERS(CALOTYPE_CLEAR)
#undef CALOTYPE_CLEAR
    hit.primitive = kNone;
    return hit;
}

/// The state of the search for what a pixel shows.
struct FirstHitSearch {
    Ray ray;
    uint passed; ///< surfaces that the ray has passed through
    bool goesOn;
    FirstHitRecord record;
};

/// The ray goes through the centres of the pixel and of the lens.
FirstHitSearch startFirstHit(Camera camera, uvec2 pixel, uvec2 imageSize) {
    Ray ray = cameraRay(camera, vec2(pixel) + 0.5, imageSize, vec2(0.0));
    return FirstHitSearch(ray, 0u, true, FirstHitRecord(firstHitOnNothing(), 0u));
}

/// Takes the hit of the ray. If the ray has passed through kMostPassedSurfaces, or `mayGoOn` is
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
