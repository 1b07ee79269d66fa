// The closed list of lights: any primitive may be one, and so may the background.
#ifndef CALOTYPE_LIGHTS_LIGHT_GLSL
#define CALOTYPE_LIGHTS_LIGHT_GLSL

#include "lights/background.glsl"
#include "lights/quadric_light.glsl"
#include "lights/sphere_light.glsl"
#include "lights/triangle_light.glsl"
#include "scene/buffers.glsl"
#include "scene/features.glsl"

/// floor(u * count) without rounding, for a multiple u of 2^-24 below 1.
uint scaledFloor(float u, uint count) {
    uint floorOfProduct, fraction;
    umulExtended(uint(u * 16777216.0) << 8u, count, floorOfProduct, fraction);
    return floorOfProduct;
}

/// Picks a light by its selectionProbability in constant time: a column of the alias table, then
/// the column's own light or its alias (Walker 1974; Vose 1991). u.x picks the column, u.y within
/// it; the chances count on both being multiples of 2^-24, and on an exact choice.
uint chooseLight(uint lightCount, vec2 u) {
    uint column = scaledFloor(u.x, lightCount);
    Light light = loadLight(column);
    return u.y < light.aliasThreshold ? column : light.alias;
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
