// A light path, one ray at a time (docs/models.md, "Light transport"). After each ray the path
// takes one of these steps, which sets the next ray and returns true, or returns false if the path
// ends:
// - pathMiss: its ray left the scene;
// - pathSurface: its ray hit a surface;
// - pathShadow: its shadow ray reached the light, or hit something opaque before it;
// - pathShadowThrough: its shadow ray hit a surface that transmits a part of the light.
#ifndef CALOTYPE_PATH_PATH_GLSL
#define CALOTYPE_PATH_PATH_GLSL

#include "path/direct_light.glsl"
#include "path/path_state.glsl"

/// Weight of light found at the end of the path's ray. After a scattering event, directLight could
/// have found the same light with density `lightPdf`. So the two share it by multiple importance
/// sampling; without that, only directLight counts it.
float bsdfWeight(Path path, float lightPdf) {
    if (path.bounce == 0u)
        return 1.0;
    if (usesMis)
        return misWeight(path.bsdfPdf, lightPdf);
    return path.bsdfPdf >= kSpecularPdf || lightPdf == 0.0 ? 1.0 : 0.0;
}

/// The point of the last event, from which the path's ray comes.
vec3 shadingPointOf(Path path) { return hasAlpha ? path.vertex : path.rayOrigin; }

/// Light from infinitely far away.
vec3 infiniteLight(Path path, Light light) {
    LightPoint point = pointAtInfinity(path.rayDirection);
    float pdf = infiniteLightPdf(light, shadingPointOf(path), point);
    return infiniteLightRadiance(light, point) * bsdfWeight(path, pdf * light.selectionProbability);
}

bool pathMiss(inout Path path, PathLimits limits) {
    if (hidesBackground && path.bounce == 0u)
        path.rayKind = kHiddenRay;
    else if (hasInfiniteLights && limits.lights.infinite != kNone)
        addRadiance(path, path.throughput * infiniteLight(path, loadLight(limits.lights.infinite)),
                    limits);
    return false;
}

/// The probability with which directLight would have chosen a light that is not infinite. Beside
/// the density of a specular direction it does not matter.
float chanceOfLight(Path path, Light light, SceneLights lights) {
    bool matters = path.bounce > 0u && path.bsdfPdf < kSpecularPdf;
    if (hasTree(lights) && !matters)
        return 1.0;
    return probabilityOf(lights, light, shadingPointOf(path));
}

/// Light that the surface emits towards the ray's origin.
vec3 emittedLight(Path path, Interaction surface, Light light, SceneLights lights) {
    LightPoint point = lightPoint(path.rayDirection, surface.position, surface.ng);
    float pdf = finiteLightPdf(light, shadingPointOf(path), point);
    float chance = chanceOfLight(path, light, lights);
    return finiteLightRadiance(light, point) * bsdfWeight(path, pdf * chance);
}

/// What a ray met.
struct MetSurface {
    Interaction surface;
    Material material;
    float alpha; ///< share of the light that the surface scatters; the rest passes through
};

MetSurface surfaceAt(Hit hit, Ray ray) {
    Interaction surface = interactionAt(hit, ray);
    Material material = materialOf(surface);
    float alpha = 1.0;
    if (hasAlpha && hit.isTransparent)
        alpha = alphaAt(material, surface.coordinates.uv);
    return MetSurface(surface, material, alpha);
}

/// True if the path continues as if the surface were not there.
bool passesThrough(Path path, MetSurface met) {
    Interaction surface = met.surface;
    bool isHidden = path.bounce == 0u && isHiddenFromCamera(surface.light);
    return isHidden || letsPass(path.id, path.bounce, surface, met.alpha, path.rayDirection);
}

/// Ends a path of low throughput at random, and increases the weight of one that continues (Arvo
/// and Kirk 1990, "Particle Transport and Image Synthesis").
void playRoulette(inout Path path, float u) {
    if (path.bounce < kEventsBeforeRoulette)
        return;
    float carried = greatest(path.throughput) * path.etaScale;
    float survival = min(carried / kRouletteThroughput, 1.0);
    path.throughput = u >= survival ? vec3(0.0) : path.throughput / survival;
}

/// Samples a light and the path's next direction. The next ray is a shadow ray if light may arrive.
bool scatter(inout Path path, Interaction surface, Material material, PathLimits limits) {
    vec3 wo = -path.rayDirection;
    applyTextures(material, surface);
    Bsdf bsdf = makeBsdf(material, surface.ng, surface.ns, surface.horizon, wo);
    Departure from = departureFrom(surface, bsdf.ng);

    // Direct light first: the throughput does not include the next direction yet.
    DirectLight light = DirectLight(pathRay(path), kNone, vec3(0.0));
    if (hasLights && !isSpecular(bsdf)) {
        vec4 uLight = samplerNumbers(path.id, bounceDimension(path.bounce, kDimensionLight));
        light = directLight(bsdf, from, uLight, limits.lights);
    }
    path.arriving = path.throughput * light.radiance;

    // The next direction.
    vec4 u = samplerNumbers(path.id, bounceDimension(path.bounce, kDimensionBsdf));
    BsdfSample scattered = sampleBsdf(bsdf, u.xyz);
    path.throughput *= scattered.weight;
    if (hasCrossing && scattered.crosses)
        path.etaScale *= scattered.eta * scattered.eta;
    path.vertex = scattered.crosses ? from.farSide : from.viewerSide;
    path.nextDirection = scattered.wi;
    path.bsdfPdf = scattered.pdf;
    path.bounce++;
    if (usesRoulette)
        playRoulette(path, u.w);

    bool goesOn = leaveVertex(path);
    if (greatest(path.arriving) > 0.0) {
        setRay(path, light.ray, kShadowRay, light.target);
        goesOn = true;
    }
    return goesOn;
}

bool pathSurface(inout Path path, MetSurface met, PathLimits limits) {
    Interaction surface = met.surface;
    if (passesThrough(path, met)) {
        path.rayOrigin = pointBeyond(surface, path.rayDirection);
        return true;
    }
    if (hasLights && surface.light != kNone)
        addRadiance(path,
                    path.throughput *
                        emittedLight(path, surface, loadLight(surface.light), limits.lights),
                    limits);
    if (path.bounce == limits.maxBounces)
        return false;
    return scatter(path, surface, met.material, limits);
}

bool pathShadow(inout Path path, bool isLit, PathLimits limits) {
    addRadiance(path, isLit ? path.arriving : vec3(0.0), limits);
    return leaveVertex(path);
}

bool pathShadowThrough(inout Path path, MetSurface met) {
    path.arriving *= 1.0 - met.alpha;
    setRay(path, rayBeyond(met.surface, pathRay(path)), kShadowRay, path.target);
    return greatest(path.arriving) > 0.0 || leaveVertex(path);
}

/// Most passes of loops that a step takes: to choose a light, for the probability of a light that
/// was hit, and for that with which a light would be chosen from the far side.
uint passesOfStep(SceneLights lights) {
    return (hasTransmission ? 3u : 2u) * passesOfChoice(lights);
}

/// Takes the step that follows from the kind of the path's ray and its hit.
bool stepPath(inout Path path, Hit hit, PathLimits limits) {
    bool isTranslucent = hasAlpha && hit.isTransparent;
    if (hasShadowRay(path) && !isTranslucent)
        return pathShadow(path, hit.primitive == kNone, limits);
    if (hit.primitive == kNone)
        return pathMiss(path, limits);
    MetSurface met = surfaceAt(hit, pathRay(path));
    if (hasAlpha && hasShadowRay(path))
        return pathShadowThrough(path, met);
    return pathSurface(path, met, limits);
}

#endif
