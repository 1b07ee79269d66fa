// What a pixel shows, for denoisers and compositors: rays through the film's filter and the lens,
// each followed through surfaces that only mirror and refract to the first other one.
#ifndef CALOTYPE_PATH_FEATURES_GLSL
#define CALOTYPE_PATH_FEATURES_GLSL

#include "config/sampler.glsl"
#include "config/settings.glsl"
#include "film/film_filter.glsl"
#include "lights/light.glsl"
#include "path/camera.glsl"
#include "path/visibility.glsl"
#include "shared/layers.h"
#include "shared/limits.h"
#include "shared/render_structs.h"

/// The state of the search for what one ray shows.
struct FeatureSearch {
    SampleId id;
    Ray ray;
    vec3 throughput;
    uint bounce; ///< specular events so far
    bool goesOn;
    FeatureRecord record;
};

/// All fields are 0.
Features noFeatures() {
    Features features;
#define CALOTYPE_CLEAR(name, type, channels, help) features.name = type(0);
    CALOTYPE_AVERAGED_LAYERS(CALOTYPE_CLEAR)
#undef CALOTYPE_CLEAR
    return features;
}

FeatureSearch startFeatures(SampleId id, Camera camera, uvec2 imageSize) {
    vec4 u = samplerNumbers(id, kDimensionCamera);
    vec2 filmPosition = vec2(id.pixel) + sampleFilm(camera, u.xy);
    return FeatureSearch(id, cameraRay(camera, filmPosition, imageSize, u.zw), vec3(1.0), 0u, true,
                         FeatureRecord(noFeatures(), kNone, 0u));
}

/// A light has the albedo that it shows on a display.
vec3 albedoOfLight(vec3 radiance) { return clamp(radiance, 0.0, 1.0); }

/// Mirrors or refracts the ray at a surface that does nothing else. False if no light goes on.
bool followSpecular(inout FeatureSearch search, Bsdf bsdf, Interaction surface) {
    vec4 u = samplerNumbers(search.id, bounceDimension(search.bounce, kDimensionBsdf));
    BsdfSample scattered = sampleBsdf(bsdf, u.xyz);
    search.throughput *= scattered.weight;
    vec3 side = scattered.crosses ? -bsdf.ng : bsdf.ng;
    search.ray = Ray(offsetFromSurface(surface.position, surface.error, side), kFar, scattered.wi);
    search.bounce++;
    return greatest(search.throughput) > 0.0;
}

/// Takes the hit of the ray. If `mayGoOn` is false, the search ends at this surface, and its record
/// says that it was cut where it should have gone on.
void extendFeatures(inout FeatureSearch search, Hit hit, Camera camera, uint infiniteLight,
                    bool mayGoOn) {
    search.goesOn = false;
    vec3 wo = -search.ray.direction;
    if (hit.primitive == kNone) {
        bool isHidden = hidesBackground && search.bounce == 0u;
        if (hasInfiniteLights && infiniteLight != kNone && !isHidden)
            search.record.features.meanAlbedo =
                search.throughput * albedoOfLight(infiniteLightRadiance(loadLight(infiniteLight),
                                                                        pointAtInfinity(-wo)));
        return;
    }
    Interaction surface = interactionAt(hit, search.ray);
    Material material = materialOf(surface);
    float alpha = hasAlpha && hit.isTransparent ? alphaAt(material, surface.coordinates.uv) : 1.0;
    bool isHidden = search.bounce == 0u && isHiddenFromCamera(surface.light);
    if (isHidden || letsPass(search.id, search.bounce, surface, alpha, search.ray.direction)) {
        search.ray.origin = pointBeyond(surface, search.ray.direction);
        search.goesOn = mayGoOn;
        search.record.isCut = mayGoOn ? 0u : 1u;
        return;
    }
    if (search.bounce == 0u) {
        search.record.features.meanDepth = dot(surface.position - camera.position, camera.forward);
        search.record.features.alpha = 1.0;
        search.record.primitive = surface.id;
    }
    vec3 albedo = vec3(0.0);
    if (hasLights && surface.light != kNone)
        albedo = albedoOfLight(
            finiteLightRadiance(loadLight(surface.light),
                                lightPoint(search.ray.direction, surface.position, surface.ng)));
    applyTextures(material, surface);
    Bsdf bsdf = makeBsdf(material, surface.ng, surface.ns, surface.horizon, wo);
    bool isClear = hasSpecular && isSpecular(bsdf) && search.bounce < kMostSpecularEvents;
    if (isClear && greatest(albedo) == 0.0 && followSpecular(search, bsdf, surface)) {
        search.goesOn = mayGoOn;
        search.record.isCut = mayGoOn ? 0u : 1u;
        return;
    }
    float side = dot(wo, surface.ng) >= 0.0 ? 1.0 : -1.0;
    search.record.features.meanAlbedo = search.throughput * max(albedo, surfaceAlbedo(material));
    search.record.features.meanNormal = side * surface.ns;
}

#endif
