// Constant radiance from all directions, sampled uniformly on the sphere (docs/models.md,
// "Background").
#ifndef CALOTYPE_LIGHTS_BACKGROUND_LIGHT_GLSL
#define CALOTYPE_LIGHTS_BACKGROUND_LIGHT_GLSL

#include "core/constants.glsl"
#include "core/trigonometry.glsl"
#include "lights/light_sample.glsl"
#include "shared/scene_structs.h"

float pdfOfBackgroundLight(Light light, vec3 shadingPoint, LightPoint point) {
    return 0.25 * kInvPi;
}

LightSample sampleBackgroundLight(Light light, vec3 shadingPoint, vec2 u) {
    float z = 1.0 - 2.0 * u.x;
    float sinTheta = 2.0 * sqrt(u.x * (1.0 - u.x));
    vec2 sinCosPhi = sinCosTwoPi(u.y);
    vec3 wi = vec3(sinTheta * sinCosPhi.y, sinTheta * sinCosPhi.x, z);
    LightPoint point = pointAtInfinity(wi);
    return LightSample(point, pdfOfBackgroundLight(light, shadingPoint, point));
}

vec3 radianceOfBackgroundLight(Light light, LightPoint point) { return light.radiance; }

#endif
