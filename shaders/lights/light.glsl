// The closed list of lights: any primitive may be one, and so may the background.
#ifndef CALOTYPE_LIGHTS_LIGHT_GLSL
#define CALOTYPE_LIGHTS_LIGHT_GLSL

#include "buffers/packed_scene.glsl"
#include "config/features.glsl"
#include "core/constants.glsl"
#include "core/random.glsl"
#include "lights/background.glsl"
#include "lights/quadric_light.glsl"
#include "lights/sphere_light.glsl"
#include "lights/triangle_light.glsl"

struct LightChoice {
    uint light;
    float u; ///< in [0, 1): where among the random numbers that choose the light there
};

/// Picks a light by its selectionProbability in constant time: a column of the alias table, then
/// the column's own light or its alias (Walker 1974; Vose 1991). u.x is one of the 2^24 random
/// numbers, each of which chooses exactly what the table says. Its place in the run of those that
/// choose the same, with u.y for the way to the next, is again uniform, and spread over the light
/// as evenly as u.x is over them all.
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

bool isQuadricLight(Light light) {
    return hasQuadricLights && (!hasTriangleLights || (light.primitive & kQuadricBit) != 0u);
}

/// Whether a primitive's light, or kNone, is one that camera rays pass through.
bool isHiddenFromCamera(uint light) {
    return hasHiddenLights && light != kNone &&
           (loadLight(light).flags & kLightHiddenFromCamera) != 0u;
}

bool isBackground(Light light) { return hasBackground && light.primitive == kBackground; }

bool isSphereLight(Quadric quadric) { return hasSphereLights && quadric.kind == kSphere; }

/// A point on the light for lighting `reference`; of any light but the background.
SurfaceSample sampleLight(Light light, vec3 reference, vec2 u) {
    if (isQuadricLight(light)) {
        Quadric quadric = loadQuadric(light.primitive & ~kQuadricBit);
        if (isSphereLight(quadric))
            return sampleSphereLight(quadric, light.area, reference, u);
        return sampleQuadricLight(quadric, light.area, reference, u);
    }
    return sampleTriangleLight(loadTriangle(light.primitive), light.area, reference, u);
}

/// Density per solid angle with which sampleLight chooses a point that is seen from `reference`: 0
/// on the far side of a closed light, which only a ray through the alpha of its near side meets.
float lightPdf(Light light, vec3 reference, vec3 position, vec3 normal) {
    if (isQuadricLight(light)) {
        Quadric quadric = loadQuadric(light.primitive & ~kQuadricBit);
        if (hasAlpha && isOnFarSide(quadric, reference, position, normal))
            return 0.0;
        if (isSphereLight(quadric))
            return sphereLightPdf(quadric, light.area, reference, position, normal);
    }
    return solidAnglePdf(light.area, reference, position, normal);
}

/// Radiance that leaves the light at a point with front `normal` in direction `w`.
vec3 emittedRadiance(Light light, vec3 normal, vec3 w) {
    bool emits = dot(normal, w) > 0.0 || (light.flags & kLightEmitsFromBack) != 0u;
    return emits ? light.radiance : vec3(0.0);
}

#endif
