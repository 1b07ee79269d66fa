// The complete list of lights, chosen by Light.kind: any primitive, and the background, can be one.
// The contract of a kind is in lights/light_sample.glsl.
#ifndef CALOTYPE_LIGHTS_LIGHT_GLSL
#define CALOTYPE_LIGHTS_LIGHT_GLSL

#include "buffers/packed_scene.glsl"
#include "config/features.glsl"
#include "core/constants.glsl"
#include "core/random.glsl"
#include "lights/background_light.glsl"
#include "lights/light_kind.glsl"
#include "lights/light_tree.glsl"
#include "lights/sphere_light.glsl"
#include "lights/triangle_light.glsl"
#include "lights/uniform_quadric_light.glsl"

/// All lights of a scene.
struct SceneLights {
    uint count;
    uint infinite;  ///< the light of rays that hit no surface, or kNone
    uint treeDepth; ///< of the light tree; 0: the alias table chooses
};

struct LightChoice {
    uint index;
    Light light;
    float u;                 ///< uniform in [0, 1), also given that this light was chosen
    float probability;       ///< with which it was chosen
    float probabilityForMis; ///< probabilityOf it, for the same point
};

/// Chooses a light by its selectionProbability in constant time: a column of the alias table, then
/// the column's own light or its alias (Walker 1974; Vose 1991). u.x is one of the 2^24 random
/// numbers; the table says exactly which light each of them chooses. The position of u.x among the
/// consecutive numbers that choose the same light, with u.y as the fraction, gives a new uniform
/// number. It is as evenly distributed for this light as u.x is for all.
LightChoice chooseInTable(uint lightCount, vec2 u) {
    uint number = uint(u.x * kUnitSteps);
    uint column, ignored;
    umulExtended(number << 8u, lightCount, column, ignored);
    Light light = loadLight(column);
    uint place = number - light.firstNumber;
    bool isOwn = place < light.ownNumbers;
    uint run = isOwn ? light.ownNumbers : light.aliasNumbers;
    float inRun = float(isOwn ? place : place - light.ownNumbers) + u.y;
    uint chosen = isOwn ? column : light.alias;
    light = loadLight(chosen);
    return LightChoice(chosen, light, min(inRun / float(run), kOneMinusEpsilon),
                       light.selectionProbability, light.selectionProbability);
}

/// Whether a tree chooses among the lights that are not infinite.
bool hasTree(SceneLights lights) { return hasLightTree && lights.treeDepth > 0u; }

/// Chooses a light for a point: the infinite light with its selectionProbability, by the greatest
/// numbers, or one by the tree. u is that of chooseInTable.
LightChoice chooseFor(SceneLights lights, LitPoint p, vec2 u) {
    float ofInfinite = hasInfiniteLights && lights.infinite != kNone
                           ? loadLight(lights.infinite).selectionProbability
                           : 0.0;
    PlaceInInterval number = PlaceInInterval(uint(u.x * kUnitSteps), u.y, kUnitSteps);
    uint chosen = lights.infinite;
    bool isInTree = takesFirst(number, (1.0 - ofInfinite) * kUnitSteps);
    float sizeForMis = number.size;
    if (isInTree)
        chosen = chooseInTree(p, number, sizeForMis);
    float place = (float(number.place) + number.fraction) / number.size;
    return LightChoice(chosen, loadLight(chosen), min(place, kOneMinusEpsilon),
                       number.size / kUnitSteps, sizeForMis / kUnitSteps);
}

/// Chooses a light to illuminate a point. u is that of chooseInTable.
LightChoice chooseLight(SceneLights lights, LitPoint p, vec2 u) {
    if (hasTree(lights))
        return chooseFor(lights, p, u);
    return chooseInTable(lights.count, u);
}

/// The probability with which chooseLight would choose that light if it did not know the normal of
/// the point, which a path does not store until it finds the light.
float probabilityOf(SceneLights lights, Light light, vec3 shadingPoint) {
    if (!hasTree(lights) || isInfiniteLight(light))
        return light.selectionProbability;
    float size = light.selectionProbability * kUnitSteps;
    return sizeInTree(light.alias, shadingPoint, size) / kUnitSteps;
}

/// Most passes of loops that chooseLight takes, or probabilityOf: one for each node, and the last,
/// which only leaves the loop.
uint passesOfChoice(SceneLights lights) { return hasTree(lights) ? lights.treeDepth + 1u : 0u; }

/// Whether camera rays pass through this light; false for kNone.
bool isHiddenFromCamera(uint light) {
    return hasHiddenLights && light != kNone &&
           (loadLight(light).flags & kLightHiddenFromCamera) != 0u;
}

// The functions below have a line for each kind of the table that has the sort Area or Infinite.
#define IF_AREA_Area(id, statement)                                                                \
    if (isOfKind(light, kLight##id, has##id##Lights, kAreaKinds == 1u))                            \
    statement
#define IF_AREA_UniformQuadric(id, statement)
#define IF_AREA_Infinite(id, statement)
#define IF_INFINITE_Area(id, statement)
#define IF_INFINITE_UniformQuadric(id, statement)
#define IF_INFINITE_Infinite(id, statement)                                                        \
    if (isOfKind(light, kLight##id, has##id##Lights, kInfiniteKinds == 1u))                        \
    statement

/// Samples a point on the light to illuminate `shadingPoint`.
LightSample sampleLight(Light light, vec3 shadingPoint, vec2 u) {
    if (isInfiniteLight(light)) {
#define LIGHT(id, sort, people)                                                                    \
    IF_INFINITE_##sort(id, return sample##id##Light(light, shadingPoint, u);)
#include "shared/feature_table.h"
    }
    if (isUniformQuadricLight(light))
        return sampleUniformQuadricLight(light, shadingPoint, u);
#define LIGHT(id, sort, people)                                                                    \
    IF_AREA_##sort(id, return sample##id##Light(light, shadingPoint, u);)
#include "shared/feature_table.h"
    return LightSample(pointAtInfinity(vec3(0.0)), 0.0);
}

/// Density per solid angle with which sampleLight chooses a point that `shadingPoint` sees. The
/// light is not infinite. 0 on the far side of a closed light: only a ray through a transparent
/// point of its near side gets there.
float finiteLightPdf(Light light, vec3 shadingPoint, LightPoint point) {
    if (isUniformQuadricLight(light))
        return pdfOfUniformQuadricLight(light, shadingPoint, point);
    float result = 0.0;
#define LIGHT(id, sort, people)                                                                    \
    IF_AREA_##sort(id, result = pdfOf##id##Light(light, shadingPoint, point);)
#include "shared/feature_table.h"
    return result;
}

/// Density per solid angle with which sampleLight chooses a direction of an infinite light.
float infiniteLightPdf(Light light, vec3 shadingPoint, LightPoint point) {
    float result = 0.0;
#define LIGHT(id, sort, people)                                                                    \
    IF_INFINITE_##sort(id, result = pdfOf##id##Light(light, shadingPoint, point);)
#include "shared/feature_table.h"
    return result;
}

/// Radiance of a light that is not infinite from a point of it.
vec3 finiteLightRadiance(Light light, LightPoint point) {
    if (isUniformQuadricLight(light))
        return areaLightRadiance(light, point);
    vec3 result = vec3(0.0);
#define LIGHT(id, sort, people) IF_AREA_##sort(id, result = radianceOf##id##Light(light, point);)
#include "shared/feature_table.h"
    return result;
}

/// Radiance of an infinite light from a direction.
vec3 infiniteLightRadiance(Light light, LightPoint point) {
    vec3 result = vec3(0.0);
#define LIGHT(id, sort, people)                                                                    \
    IF_INFINITE_##sort(id, result = radianceOf##id##Light(light, point);)
#include "shared/feature_table.h"
    return result;
}

/// Radiance from a point of a light of any kind.
vec3 lightRadiance(Light light, LightPoint point) {
    return isInfiniteLight(light) ? infiniteLightRadiance(light, point)
                                  : finiteLightRadiance(light, point);
}

#undef IF_AREA_Area
#undef IF_AREA_UniformQuadric
#undef IF_AREA_Infinite
#undef IF_INFINITE_Area
#undef IF_INFINITE_UniformQuadric
#undef IF_INFINITE_Infinite

#endif
