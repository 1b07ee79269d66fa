// Constant radiance from all directions, sampled uniformly on the sphere (docs/models.md,
// "Background").
#ifndef CALOTYPE_LIGHTS_BACKGROUND_LIGHT_GLSL
#define CALOTYPE_LIGHTS_BACKGROUND_LIGHT_GLSL

#include "core/constants.glsl"
#include "core/warp.glsl"
#include "lights/light_sample.glsl"
#include "shared/scene_structs.h"

float pdfOfBackgroundLight(Light light, vec3 shadingPoint, LightPoint point) {
    return 0.25 * kInvPi;
}

LightSample sampleBackgroundLight(Light light, vec3 shadingPoint, vec2 u) {
    LightPoint point = pointAtInfinity(warpToSphere(u));
    return LightSample(point, pdfOfBackgroundLight(light, shadingPoint, point));
}

vec3 radianceOfBackgroundLight(Light light, LightPoint point) { return light.radiance; }

#endif
