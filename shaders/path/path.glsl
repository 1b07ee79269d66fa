// A light path, one scattering event at a time (report section on light transport, with its two
// estimates of direct light weighted by their densities instead of divided by both).
#ifndef CALOTYPE_PATH_PATH_GLSL
#define CALOTYPE_PATH_PATH_GLSL

#include "bsdf/bsdf.glsl"
#include "core/random.glsl"
#include "lights/light.glsl"
#include "path/camera.glsl"
#include "path/mis.glsl"
#include "scene/interaction.glsl"

struct Path {
    SampleId id;
    Ray ray;         ///< unit direction
    vec3 throughput; ///< product of the weights so far
    vec3 radiance;   ///< found so far
    uint bounce;     ///< scattering events so far
    float bsdfPdf;   ///< density per solid angle of the ray's direction, after an event
};

struct PathLimits {
    uint maxBounces;
    uint lightCount;
};

struct PathCost {
    uint rays;
    uint iterations; ///< see traverse
};

Path startPath(SampleId id, Camera camera, uvec2 imageSize) {
    vec2 filmPosition = vec2(id.pixel) + uniformRandom(id, kDimensionCamera).xy;
    return Path(id, cameraRay(camera, filmPosition, imageSize), vec3(1.0), vec3(0.0), 0u, 0.0);
}

/// Light that the surface emits towards the ray's origin. After a scattering event the same light
/// could have been found by directLight, so the two share it.
vec3 emittedLight(Path path, Interaction surface, Light light) {
    vec3 radiance = emittedRadiance(light, surface.ng, -path.ray.direction);
    if (path.bounce == 0u)
        return radiance;
    float pdf = lightPdf(light, path.ray.origin, surface.position, surface.ng);
    return radiance * misWeight(path.bsdfPdf, pdf * light.selectionChance);
}

/// Light from one point on one emitter, reflected towards the viewer. `origin` is the surface point
/// moved off the surface on the viewer's side.
vec3 directLight(Path path, Bsdf bsdf, vec3 origin, uint lightCount, inout PathCost cost) {
    vec4 u = uniformRandom(path.id, bounceDimension(path.bounce, kDimensionLight));
    Light light = loadLight(chooseLight(lightCount, u.xy));
    SurfaceSample point = sampleLight(light, origin, u.zw);
    vec3 toLight = point.position - origin;
    vec3 wi = toLight * inversesqrt(dot(toLight, toLight));
    vec3 reflected = evaluateBsdf(bsdf, wi) * emittedRadiance(light, point.normal, -wi);
    if (point.pdf <= 0.0 || max(max(reflected.x, reflected.y), reflected.z) <= 0.0)
        return vec3(0.0);
    vec3 facing = dot(toLight, point.normal) > 0.0 ? -point.normal : point.normal;
    vec3 target = offsetFromSurface(point.position, point.error, facing);
    cost.rays++;
    float distanceToTarget = length(target - origin);
    Ray shadowRay = Ray(origin, distanceToTarget, (target - origin) / distanceToTarget);
    if (isOccluded(shadowRay, light.primitive, cost.iterations))
        return vec3(0.0);
    float pdf = point.pdf * light.selectionChance;
    return reflected * (misWeight(pdf, bsdfPdf(bsdf, wi)) / pdf);
}

/// Follows the ray to the next surface, takes in the light there and scatters. False where the path
/// ends.
bool extendPath(inout Path path, PathLimits limits, inout PathCost cost) {
    cost.rays++;
    Hit hit = intersectClosest(path.ray, cost.iterations);
    if (hit.primitive == kNone)
        return false;
    Interaction surface = interactionAt(hit, path.ray);
    vec3 wo = -path.ray.direction;
    if (hasLights && surface.light != kNone) {
        Light light = loadLight(surface.light);
        if (hasHiddenLights && path.bounce == 0u && (light.flags & kLightHiddenFromCamera) != 0u) {
            vec3 beyond = dot(wo, surface.ng) > 0.0 ? -surface.ng : surface.ng;
            path.ray.origin = offsetFromSurface(surface.position, surface.error, beyond);
            return true;
        }
        path.radiance += path.throughput * emittedLight(path, surface, light);
    }
    if (path.bounce == limits.maxBounces)
        return false;
    Bsdf bsdf = makeBsdf(loadMaterial(surface.material), surface.ng, surface.ns, wo);
    vec3 origin = offsetFromSurface(surface.position, surface.error, bsdf.ng);
    if (hasLights)
        path.radiance += path.throughput * directLight(path, bsdf, origin, limits.lightCount, cost);
    vec2 u = uniformRandom(path.id, bounceDimension(path.bounce, kDimensionBsdf)).xy;
    BsdfSample scattered = sampleBsdf(bsdf, u);
    path.throughput *= scattered.weight;
    path.ray = Ray(origin, kFar, scattered.wi);
    path.bsdfPdf = scattered.pdf;
    path.bounce++;
    return max(max(path.throughput.x, path.throughput.y), path.throughput.z) > 0.0;
}

#endif
