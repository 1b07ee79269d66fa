// Light that comes straight from one emitter, chosen among all (docs/models.md, "Direct light").
#ifndef CALOTYPE_PATH_DIRECT_LIGHT_GLSL
#define CALOTYPE_PATH_DIRECT_LIGHT_GLSL

#include "config/transport.glsl"
#include "core/random.glsl"
#include "lights/light.glsl"
#include "path/mis.glsl"
#include "path/visibility.glsl"

struct LightSample {
    Ray ray;       ///< towards the light, ending at it
    vec3 wi;       ///< unit direction of the light
    vec3 radiance; ///< along the ray
    float pdf;     ///< per solid angle; 0 where the point cannot be seen
};

/// The share of its light that an emitter with a hole in it sends out.
float emitterAlpha(Light light, vec2 coordinates) {
    bool isQuadric = isQuadricLight(light);
    uint materialIndex = isQuadric ? loadQuadric(light.primitive & ~kQuadricBit).material
                                   : loadTriangle(light.primitive).material;
    vec2 uv = isQuadric ? coordinates : triangleUv(loadTriangleUvs(light.primitive), coordinates);
    bool transparent = (materialIndex & kTransparentBit) != 0u;
    return transparent ? alphaAt(loadMaterial(materialIndex & ~kTransparentBit), uv) : 1.0;
}

/// From `origin`, which lies off the surface on one of its sides.
LightSample sampleDirectLight(Light light, vec3 origin, vec2 u) {
    if (isBackground(light)) {
        vec3 wi = sampleBackground(u);
        return LightSample(Ray(origin, kFar, wi), wi, light.radiance, kBackgroundPdf);
    }
    SurfaceSample point = sampleLight(light, origin, u);
    vec3 facing = dot(point.wi, point.normal) > 0.0 ? -point.normal : point.normal;
    vec3 target = offsetFromSurface(point.position, point.error, facing);
    float distanceToTarget = length(target - origin);
    vec3 radiance = emittedRadiance(light, point.normal, -point.wi);
    if (hasLightAlpha)
        radiance *= emitterAlpha(light, point.coordinates);
    Ray ray = Ray(origin, distanceToTarget, (target - origin) / distanceToTarget);
    return LightSample(ray, point.wi, radiance, point.pdf);
}

/// Light on its way from one point on one emitter.
struct DirectLight {
    Ray ray;       ///< from the surface to the emitter
    uint target;   ///< the emitter's primitive, which does not stand in its own way
    vec3 radiance; ///< scattered towards the viewer if nothing stands in the way; 0 for no light
};

/// Where light leaves a surface: points off it on either side.
struct Departure {
    vec3 viewerSide; ///< off the smooth surface, where there is one
    vec3 farSide;
};

/// `ng` is the geometric normal on the viewer's side.
Departure departureFrom(Interaction surface, vec3 ng) {
    vec3 onSmooth = surface.position + surface.toSmooth;
    return Departure(offsetFromSurface(onSmooth, surface.error, ng),
                     offsetFromSurface(surface.position, surface.error, -ng));
}

/// Light from one point on one emitter, scattered towards the viewer. A light that lies on the far
/// side is sampled from there, as what crosses the surface starts there.
DirectLight directLight(Bsdf bsdf, Departure from, vec4 u, uint lightCount) {
    LightChoice choice = chooseLight(lightCount, u.xz);
    Light light = loadLight(choice.light);
    vec2 uLight = vec2(choice.u, u.y);
    LightSample arriving = sampleDirectLight(light, from.viewerSide, uLight);
    if (hasTransmission && dot(arriving.wi, bsdf.ng) < 0.0)
        arriving = sampleDirectLight(light, from.farSide, uLight);
    BsdfValue scattered = evaluateBsdf(bsdf, arriving.wi);
    vec3 radiance = scattered.value * arriving.radiance;
    float pdf = arriving.pdf * light.selectionProbability;
    bool isLit = pdf > 0.0 && greatest(radiance) > 0.0;
    float share = usesMis ? misWeight(pdf, scattered.pdf) : 1.0;
    float weight = isLit ? share / pdf : 0.0;
    return DirectLight(arriving.ray, light.primitive, isLit ? radiance * weight : vec3(0.0));
}

#endif
