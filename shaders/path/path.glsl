// A light path, one scattering event at a time (report section on light transport, with its two
// estimates of direct light weighted by their densities instead of divided by both).
#ifndef CALOTYPE_PATH_PATH_GLSL
#define CALOTYPE_PATH_PATH_GLSL

#include "config/sampler.glsl"
#include "config/transport.glsl"
#include "film/film_filter.glsl"
#include "path/camera.glsl"
#include "path/direct_light.glsl"

struct Path {
    SampleId id;
    Ray ray;         ///< to be followed next; its direction is a unit vector
    vec3 vertex;     ///< where the last event sent the path from; the ray may have gone on since
    vec3 throughput; ///< product of the weights so far
    vec3 radiance;   ///< found so far
    uint bounce;     ///< scattering events so far
    float bsdfPdf;   ///< density per solid angle of the path's direction, after an event
    float etaScale;  ///< undoes what crossing into glass took off `throughput`

    // While `ray` looks for what stands between the surface and a light:
    bool isShadowed; ///< it does
    uint target;     ///< the light's primitive, which the ray passes by; else kNone
    vec3 arriving;   ///< what it finds if nothing stands there
    vec3 direction;  ///< in which the path goes on from its vertex
};

struct PathLimits {
    uint maxBounces;
    uint lightCount;
    float indirectClamp;  ///< as in RenderParameters
    uint backgroundLight; ///< likewise
};

Path startPath(SampleId id, Camera camera, uvec2 imageSize) {
    vec4 u = samplerNumbers(id, kDimensionCamera);
    vec2 filmPosition = vec2(id.pixel) + sampleFilm(camera, u.xy);
    Ray ray = cameraRay(camera, filmPosition, imageSize, u.zw);
    return Path(id, ray, ray.origin, vec3(1.0), vec3(0.0), 0u, 0.0, 1.0, false, kNone, vec3(0.0),
                vec3(0.0));
}

/// Weight of light found at the end of the path's ray. After a scattering event the same light
/// could have been found by directLight, with density `lightPdf`, so the two share it, or without
/// multiple importance sampling it is all directLight's.
float bsdfWeight(Path path, float lightPdf) {
    if (path.bounce == 0u)
        return 1.0;
    if (usesMis)
        return misWeight(path.bsdfPdf, lightPdf);
    return path.bsdfPdf >= kSpecularPdf || lightPdf == 0.0 ? 1.0 : 0.0;
}

/// Adds light that the path found.
void addRadiance(inout Path path, vec3 found, PathLimits limits) {
    if (clampsIndirect && path.bounce >= 2u) {
        float most = greatest(found);
        found *= most > limits.indirectClamp ? limits.indirectClamp / most : 1.0;
    }
    path.radiance += found;
}

/// Ends a path of little throughput by chance, and makes up for it where the path goes on (Arvo and
/// Kirk 1990, "Particle Transport and Image Synthesis").
void playRoulette(inout Path path, float u) {
    if (path.bounce < kEventsBeforeRoulette)
        return;
    float carried = greatest(path.throughput) * path.etaScale;
    float survival = min(carried / kRouletteThroughput, 1.0);
    path.throughput = u >= survival ? vec3(0.0) : path.throughput / survival;
}

/// Light that comes from infinitely far away.
vec3 infiniteLight(Path path, Light light) {
    float pdf = infiniteLightPdf(light, path.ray.direction) * light.selectionProbability;
    return infiniteLightRadiance(light, path.ray.direction) * bsdfWeight(path, pdf);
}

/// Light that the surface emits towards the ray's origin.
vec3 emittedLight(Path path, Interaction surface, Light light) {
    vec3 reference = hasAlpha ? path.vertex : path.ray.origin;
    LightPoint point = lightPoint(path.ray.direction, surface.position, surface.ng);
    float pdf = areaLightPdf(light, reference, point);
    return areaLightRadiance(light, point) * bsdfWeight(path, pdf * light.selectionProbability);
}

/// True where the path goes on as if the surface, which `alpha` of all light meets, were not there.
/// A ray that enters and leaves the same primitive asks twice, so the sides have numbers of their
/// own.
bool passesThrough(Path path, Interaction surface, float alpha) {
    bool passes = path.bounce == 0u && isHiddenFromCamera(surface.light);
    if (hasAlpha && isTransparent(surface.material)) {
        uint fromBehind = dot(path.ray.direction, surface.ng) > 0.0 ? 1u : 0u;
        float u = uniformRandomOf(path.id, bounceDimension(path.bounce, kDimensionAlpha),
                                  2u * surface.id + fromBehind);
        passes = passes || u >= alpha;
    }
    return passes;
}

/// The path goes on from its vertex. False where nothing that it could find would count.
bool goOn(inout Path path) {
    path.ray = Ray(path.vertex, kFar, path.direction);
    path.isShadowed = false;
    path.target = kNone;
    return greatest(path.throughput) > 0.0;
}

/// Asks for light at the surface and scatters the path there. False where it ends.
bool scatter(inout Path path, Interaction surface, Material material, PathLimits limits) {
    vec3 wo = -path.ray.direction;
    SurfaceParameters parameters = surfaceParameters(material, surface);
    Bsdf bsdf = makeBsdf(parameters, surface.ng, surface.ns, surface.horizon, wo);
    Departure from = departureFrom(surface, bsdf.ng);
    DirectLight light = DirectLight(path.ray, kNone, vec3(0.0));
    if (hasLights && !isSpecular(bsdf)) {
        vec4 uLight = samplerNumbers(path.id, bounceDimension(path.bounce, kDimensionLight));
        light = directLight(bsdf, from, uLight, limits.lightCount);
    }
    path.arriving = path.throughput * light.radiance;
    vec4 u = samplerNumbers(path.id, bounceDimension(path.bounce, kDimensionBsdf));
    BsdfSample scattered = sampleBsdf(bsdf, u.xyz);
    path.throughput *= scattered.weight;
    if (hasDielectrics && scattered.crosses)
        path.etaScale *= scattered.eta * scattered.eta;
    path.vertex = scattered.crosses ? from.farSide : from.viewerSide;
    path.direction = scattered.wi;
    path.bsdfPdf = scattered.pdf;
    path.bounce++;
    if (usesRoulette)
        playRoulette(path, u.w);
    bool goesOn = goOn(path);
    if (greatest(path.arriving) > 0.0) {
        path.ray = light.ray;
        path.isShadowed = true;
        path.target = light.target;
        goesOn = true;
    }
    return goesOn;
}

/// Takes in whether the ray to a light arrived, and goes on in the path's own direction. False
/// where the path ends.
bool reachLight(inout Path path, Hit hit, PathLimits limits) {
    addRadiance(path, hit.primitive == kNone ? path.arriving : vec3(0.0), limits);
    return goOn(path);
}

/// The ray to a light goes on behind a surface that keeps `alpha` of its light.
bool passShadow(inout Path path, Interaction surface, float alpha) {
    path.arriving *= 1.0 - alpha;
    path.ray = rayBeyond(surface, path.ray);
    return greatest(path.arriving) > 0.0 || goOn(path);
}

/// Takes in what the path's ray met, if anything, and sets its next ray. False where the path ends.
bool extendPath(inout Path path, Hit hit, PathLimits limits) {
    if (hasLights && path.isShadowed && !(hasAlpha && hit.isTransparent))
        return reachLight(path, hit, limits);
    if (hit.primitive == kNone) {
        if (hasBackground && limits.backgroundLight != kNone)
            addRadiance(path,
                        path.throughput * infiniteLight(path, loadLight(limits.backgroundLight)),
                        limits);
        return false;
    }
    Interaction surface = interactionAt(hit, path.ray);
    Material material = materialOf(surface);
    float alpha = 1.0;
    if (hasAlpha && hit.isTransparent)
        alpha = alphaAt(material, surface.coordinates.uv);
    if (hasAlpha && path.isShadowed)
        return passShadow(path, surface, alpha);
    if (passesThrough(path, surface, alpha)) {
        path.ray.origin = pointBeyond(surface, path.ray.direction);
        return true;
    }
    if (hasLights && surface.light != kNone)
        addRadiance(path, path.throughput * emittedLight(path, surface, loadLight(surface.light)),
                    limits);
    if (path.bounce == limits.maxBounces)
        return false;
    return scatter(path, surface, material, limits);
}

#endif
