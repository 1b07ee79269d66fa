// The complete list of lights, chosen by Light.kind: any primitive, and the background, can be one.
// The contract of a kind is in lights/light_sample.glsl.
#ifndef CALOTYPE_LIGHTS_LIGHT_GLSL
#define CALOTYPE_LIGHTS_LIGHT_GLSL

#include "buffers/packed_scene.glsl"
#include "config/features.glsl"
#include "core/constants.glsl"
#include "core/random.glsl"
#include "lights/background_light.glsl"
#include "lights/quadric_light.glsl"
#include "lights/sphere_light.glsl"
#include "lights/triangle_light.glsl"

struct LightChoice {
    uint light;
    float u; ///< uniform in [0, 1), also given that this light was chosen
};

/// Chooses a light by its selectionProbability in constant time: a column of the alias table, then
/// the column's own light or its alias (Walker 1974; Vose 1991). u.x is one of the 2^24 random
/// numbers; the table says exactly which light each of them chooses. The position of u.x among the
/// consecutive numbers that choose the same light, with u.y as the fraction, gives a new uniform
/// number. It is as evenly distributed for this light as u.x is for all.
LightChoice chooseLight(uint lightCount, vec2 u) {
    uint number = uint(u.x * kUnitSteps);
    uint column, ignored;
    umulExtended(number << 8u, lightCount, column, ignored);
    Light light = loadLight(column);
    uint place = number - light.firstNumber;
    bool isOwn = place < light.ownNumbers;
    uint run = isOwn ? light.ownNumbers : light.aliasNumbers;
    float inRun = float(isOwn ? place : place - light.ownNumbers) + u.y;
    return LightChoice(isOwn ? column : light.alias, min(inRun / float(run), kOneMinusEpsilon));
}

/// Whether camera rays pass through this light; false for kNone.
bool isHiddenFromCamera(uint light) {
    return hasHiddenLights && light != kNone &&
           (loadLight(light).flags & kLightHiddenFromCamera) != 0u;
}

// If all lights of the scene have the same kind, the kernel does not read Light.kind.

/// A light that is infinitely far away.
bool isInfiniteLight(Light light) {
    return hasBackground && (!hasAreaLights || light.kind == kLightBackground);
}

/// The light must not be infinite.
bool isTriangleLight(Light light) {
    return hasTriangleLights && (!hasQuadricLights || light.kind == kLightTriangle);
}

/// The light must be neither infinite nor a triangle.
bool isSphereLight(Light light) {
    return hasSphereLights && (!hasOtherQuadricLights || light.kind == kLightSphere);
}

Quadric quadricOf(Light light) { return loadQuadric(light.primitive & ~kQuadricBit); }

/// Samples a point on the light to illuminate `reference`.
LightSample sampleLight(Light light, vec3 reference, vec2 u) {
    if (isInfiniteLight(light))
        return sampleBackgroundLight(u);
    if (isTriangleLight(light))
        return sampleTriangleLight(loadTriangle(light.primitive), light.area, reference, u);
    Quadric quadric = quadricOf(light);
    if (isSphereLight(light))
        return sampleSphereLight(quadric, light.area, reference, u);
    return sampleQuadricLight(light.kind, quadric, light.area, reference, u);
}

/// Density per solid angle with which sampleLight chooses a point that `reference` sees. The light
/// is not infinite. 0 on the far side of a closed light: only a ray through a transparent point of
/// its near side gets there.
float areaLightPdf(Light light, vec3 reference, LightPoint point) {
    if (hasQuadricLights && !isTriangleLight(light)) {
        Quadric quadric = quadricOf(light);
        if (hasAlpha && isOnFarSide(quadric, reference, point.position, point.normal))
            return 0.0;
        if (isSphereLight(light))
            return sphereLightPdf(quadric, light.area, reference, point);
    }
    return solidAnglePdf(light.area, reference, point.position, point.normal);
}

/// Density per solid angle with which sampleLight chooses a direction of an infinite light.
float infiniteLightPdf(Light light, vec3 wi) { return backgroundLightPdf(wi); }

/// Radiance of an infinite light from a direction.
vec3 infiniteLightRadiance(Light light, vec3 wi) { return backgroundLightRadiance(light, wi); }

/// Radiance from a point of a light of any kind.
vec3 lightRadiance(Light light, LightPoint point) {
    return isInfiniteLight(light) ? infiniteLightRadiance(light, point.wi)
                                  : areaLightRadiance(light, point);
}

#endif
