// Direct light from one emitter, chosen among all (docs/models.md, "Direct light").
#ifndef CALOTYPE_PATH_DIRECT_LIGHT_GLSL
#define CALOTYPE_PATH_DIRECT_LIGHT_GLSL

#include "config/settings.glsl"
#include "core/random.glsl"
#include "lights/light.glsl"
#include "path/mis.glsl"
#include "path/visibility.glsl"

/// The alpha of the emitter's own surface: the share of its light that it emits there.
float emitterAlpha(Light light, vec2 coordinates) {
    if (light.primitive == kNone)
        return 1.0;
    bool isTriangle =
        hasTriangleLights && (!hasQuadricLights || (light.primitive & kQuadricBit) == 0u);
    uint materialIndex = isTriangle ? loadTriangle(light.primitive).material
                                    : loadQuadric(light.primitive & ~kQuadricBit).material;
    vec2 uv = isTriangle ? triangleUv(loadTriangleUvs(light.primitive), coordinates) : coordinates;
    bool transparent = (materialIndex & kTransparentBit) != 0u;
    return transparent ? alphaAt(loadMaterial(materialIndex & ~kTransparentBit), uv) : 1.0;
}

/// The ray from `origin` to a point of the light.
Ray rayToLight(Light light, LightPoint point, vec3 origin) {
    if (isInfiniteLight(light))
        return Ray(origin, kFar, point.wi);
    vec3 facing = dot(point.wi, point.normal) > 0.0 ? -point.normal : point.normal;
    vec3 target = offsetFromSurface(point.position, point.error, facing);
    float distanceToTarget = length(target - origin);
    return Ray(origin, distanceToTarget, (target - origin) / distanceToTarget);
}

/// The radiance from a point of the light, reduced by the alpha of its own surface.
vec3 arrivingRadiance(Light light, LightPoint point) {
    vec3 radiance = lightRadiance(light, point);
    if (hasLightAlpha)
        radiance *= emitterAlpha(light, point.coordinates);
    return radiance;
}

/// Light from one point on one emitter, before its shadow ray is traced.
struct DirectLight {
    Ray ray;       ///< from the surface to the emitter
    uint target;   ///< the emitter's primitive, which the ray ignores
    vec3 radiance; ///< scattered towards the viewer if nothing blocks it; 0 for no light
};

/// Origins of the rays that leave a surface, on both sides.
struct Departure {
    vec3 viewerSide; ///< off the smooth surface, if there is one
    vec3 farSide;
};

/// `ng` is the geometric normal on the viewer's side.
Departure departureFrom(Interaction surface, vec3 ng) {
    vec3 onSmooth = surface.position + surface.toSmooth;
    return Departure(offsetFromSurface(onSmooth, surface.error, ng),
                     offsetFromSurface(surface.position, surface.error, -ng));
}

/// Light from one point on one emitter, scattered towards the viewer. If the light is on the far
/// side, it is sampled from the far side's origin, because transmitted rays start there.
///
/// Where a ray hits the light, the probability with which it was chosen here is not known, but that
/// without the normal and, if the ray was transmitted, for the far side. So both ways to find the
/// light are weighted by the latter: MIS only needs weights that sum to 1.
DirectLight directLight(Bsdf bsdf, Departure from, vec4 u, SceneLights lights) {
    LitPoint lit = LitPoint(from.viewerSide, bsdf.worldFromShading[2]);
    LightChoice choice = chooseLight(lights, lit, u.xz);
    Light light = choice.light;
    vec2 uLight = vec2(choice.u, u.y);
    vec3 origin = from.viewerSide;
    float chanceForMis = choice.probabilityForMis;
    LightSample chosen = sampleLight(light, origin, uLight);
    if (hasTransmission && dot(chosen.point.wi, bsdf.ng) < 0.0) {
        origin = from.farSide;
        chosen = sampleLight(light, origin, uLight);
        chanceForMis = probabilityOf(lights, light, origin);
    }
    BsdfValue scattered = evaluateBsdf(bsdf, chosen.point.wi);
    vec3 radiance = scattered.value * arrivingRadiance(light, chosen.point);
    float pdf = chosen.pdf * choice.probability;
    bool isLit = pdf > 0.0 && greatest(radiance) > 0.0;
    float share = usesMis ? misWeight(chosen.pdf * chanceForMis, scattered.pdf) : 1.0;
    float weight = isLit ? share / pdf : 0.0;
    return DirectLight(rayToLight(light, chosen.point, origin), light.primitive,
                       isLit ? radiance * weight : vec3(0.0));
}

#endif
