// Functions shared by all lights that have an area.
#ifndef CALOTYPE_LIGHTS_AREA_LIGHT_GLSL
#define CALOTYPE_LIGHTS_AREA_LIGHT_GLSL

#include "lights/light_sample.glsl"
#include "shared/scene_structs.h"

/// The density per area, 1 / area, converted to solid angle (docs/models.md, "Direct light"):
/// distance^2 / (cos theta area). Zero if the surface is seen edge-on.
float solidAnglePdf(float area, vec3 shadingPoint, vec3 position, vec3 normal) {
    vec3 d = position - shadingPoint;
    float distance2 = dot(d, d);
    float cosTheta = abs(dot(d * inversesqrt(distance2), normal));
    return cosTheta > 0.0 ? distance2 / (cosTheta * area) : 0.0;
}

/// The density of a light that is sampled by uniform points on its area.
float uniformPointPdf(Light light, vec3 shadingPoint, LightPoint point) {
    return solidAnglePdf(light.area, shadingPoint, point.position, point.normal);
}

/// Emitted from the front, or from both sides.
vec3 areaLightRadiance(Light light, LightPoint point) {
    bool emits = dot(point.normal, point.wi) < 0.0 || (light.flags & kLightEmitsFromBack) != 0u;
    return emits ? light.radiance : vec3(0.0);
}

#endif
