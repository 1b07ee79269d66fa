// A light path, one scattering event at a time (report section on light transport, with its two
// estimates of direct light weighted by their densities instead of divided by both).
#ifndef CALOTYPE_PATH_PATH_GLSL
#define CALOTYPE_PATH_PATH_GLSL

#include "path/camera.glsl"
#include "path/direct_light.glsl"
#include "scene/film_filter.glsl"

struct Path {
    SampleId id;
    Ray ray;         ///< unit direction
    vec3 vertex;     ///< where the last event sent the ray from; the ray may have gone on since
    vec3 throughput; ///< product of the weights so far
    vec3 radiance;   ///< found so far
    uint bounce;     ///< scattering events so far
    float bsdfPdf;   ///< density per solid angle of the ray's direction, after an event
};

struct PathLimits {
    uint maxBounces;
    uint lightCount;
};

Path startPath(SampleId id, Camera camera, uvec2 imageSize) {
    vec4 u = uniformRandom(id, kDimensionCamera);
    vec2 filmPosition = vec2(id.pixel) + sampleFilm(camera, u.xy);
    Ray ray = cameraRay(camera, filmPosition, imageSize, u.zw);
    return Path(id, ray, ray.origin, vec3(1.0), vec3(0.0), 0u, 0.0);
}

/// Weight of light found at the end of the path's ray. After a scattering event the same light
/// could have been found by directLight, with density `lightPdf`, so the two share it.
float bsdfMisWeight(Path path, float lightPdf) {
    return path.bounce == 0u ? 1.0 : misWeight(path.bsdfPdf, lightPdf);
}

/// Light that comes from beyond all surfaces; the background, if there is one, is the last light.
vec3 backgroundLight(Path path, uint lightCount) {
    Light light = loadLight(max(lightCount, 1u) - 1u);
    vec3 radiance = isBackground(light) ? light.radiance : vec3(0.0);
    return radiance * bsdfMisWeight(path, kBackgroundPdf * light.selectionProbability);
}

/// Light that the surface emits towards the ray's origin.
vec3 emittedLight(Path path, Interaction surface, Light light) {
    vec3 reference = hasAlpha ? path.vertex : path.ray.origin;
    float pdf = lightPdf(light, reference, surface.position, surface.ng);
    return emittedRadiance(light, surface.ng, -path.ray.direction) *
           bsdfMisWeight(path, pdf * light.selectionProbability);
}

/// True where the path goes on as if the surface were not there. A ray that enters and leaves the
/// same primitive asks twice, so the sides have numbers of their own.
bool passesThrough(Path path, Interaction surface) {
    bool passes = path.bounce == 0u && isHiddenFromCamera(surface.light);
    if (hasAlpha && (surface.material & kTransparentBit) != 0u) {
        uint fromBehind = dot(path.ray.direction, surface.ng) > 0.0 ? 1u : 0u;
        float u = uniformRandomOf(path.id, bounceDimension(path.bounce, kDimensionAlpha),
                                  2u * surface.id + fromBehind);
        passes = passes || u >= alphaAt(materialOf(surface), surface.coordinates.uv);
    }
    return passes;
}

/// Lights the surface and sends the path on. False where it ends.
bool scatter(inout Path path, Interaction surface, PathLimits limits, inout PathCost cost) {
    vec3 wo = -path.ray.direction;
    SurfaceParameters parameters = surfaceParameters(materialOf(surface), surface);
    Bsdf bsdf = makeBsdf(parameters, surface.ng, surface.ns, surface.horizon, wo);
    vec3 origin = offsetFromSurface(surface.position + surface.toSmooth, surface.error, bsdf.ng);
    if (hasLights && !isSpecular(bsdf)) {
        vec4 uLight = uniformRandom(path.id, bounceDimension(path.bounce, kDimensionLight));
        path.radiance +=
            path.throughput * directLight(bsdf, origin, uLight, limits.lightCount, cost);
    }
    vec3 u = uniformRandom(path.id, bounceDimension(path.bounce, kDimensionBsdf)).xyz;
    BsdfSample scattered = sampleBsdf(bsdf, u);
    path.throughput *= scattered.weight;
    path.vertex =
        scattered.crosses ? offsetFromSurface(surface.position, surface.error, -bsdf.ng) : origin;
    path.ray = Ray(path.vertex, kFar, scattered.wi);
    path.bsdfPdf = scattered.pdf;
    path.bounce++;
    return greatest(path.throughput) > 0.0;
}

/// Follows the ray to the next surface, takes in the light there and scatters. False where the path
/// ends.
bool extendPath(inout Path path, PathLimits limits, inout PathCost cost) {
    cost.rays++;
    Hit hit = intersectClosest(path.ray, cost.iterations);
    if (hit.primitive == kNone) {
        if (hasBackground)
            path.radiance += path.throughput * backgroundLight(path, limits.lightCount);
        return false;
    }
    Interaction surface = interactionAt(hit, path.ray);
    if (passesThrough(path, surface)) {
        path.ray.origin = pointBeyond(surface, path.ray.direction);
        return true;
    }
    if (hasLights && surface.light != kNone)
        path.radiance += path.throughput * emittedLight(path, surface, loadLight(surface.light));
    if (path.bounce == limits.maxBounces)
        return false;
    return scatter(path, surface, limits, cost);
}

#endif
