// Quadrics that are sampled by uniform points on their area (docs/models.md, "Quadric lights").
//
// The file lights/<kind>_light.glsl of such a kind declares, besides what all of them share here:
//
//   vec3 sample<Kind>(Quadric quadric, vec2 u)
//       A uniform point of the surface, in the quadric's frame; each component of u is uniform in
//       [0, 1).
#ifndef CALOTYPE_LIGHTS_UNIFORM_QUADRIC_LIGHT_GLSL
#define CALOTYPE_LIGHTS_UNIFORM_QUADRIC_LIGHT_GLSL

#include "lights/cone_light.glsl"
#include "lights/cylinder_light.glsl"
#include "lights/disk_light.glsl"
#include "lights/light_kind.glsl"
#include "lights/quadric_light.glsl"

/// A uniform point of the light, in the quadric's frame.
vec3 sampleUniformQuadric(Light light, Quadric quadric, vec2 u) {
    vec3 result = vec3(0.0);
#define SAMPLE_Area(id)
#define SAMPLE_UniformQuadric(id)                                                                  \
    if (isOfKind(light, kLight##id, has##id##Lights, kUniformQuadricKinds == 1u))                  \
        result = sample##id(quadric, u);
#define SAMPLE_Infinite(id)
#define LIGHT(id, sort, people) SAMPLE_##sort(id)
#include "shared/feature_table.h"
#undef SAMPLE_Area
#undef SAMPLE_UniformQuadric
#undef SAMPLE_Infinite
    return result;
}

LightSample sampleUniformQuadricLight(Light light, vec3 shadingPoint, vec2 u) {
    Quadric quadric = quadricOf(light);
    vec3 local = sampleUniformQuadric(light, quadric, u);
    LightPoint point = quadricLightPoint(quadric, local, shadingPoint);
    bool isHidden = isOnFarSide(quadric, shadingPoint, point.position, point.normal);
    return LightSample(point, isHidden ? 0.0 : uniformPointPdf(light, shadingPoint, point));
}

float pdfOfUniformQuadricLight(Light light, vec3 shadingPoint, LightPoint point) {
    return isMetOnFarSide(quadricOf(light), shadingPoint, point)
               ? 0.0
               : uniformPointPdf(light, shadingPoint, point);
}

#endif
