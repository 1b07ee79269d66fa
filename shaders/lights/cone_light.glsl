// A closed cone that emits, sampled by uniform points (docs/models.md, "Quadric lights").
#ifndef CALOTYPE_LIGHTS_CONE_LIGHT_GLSL
#define CALOTYPE_LIGHTS_CONE_LIGHT_GLSL

#include "core/warp.glsl"
#include "lights/quadric_light.glsl"

/// In the quadric's frame, on the side or the base, chosen by area. On the side the distance from
/// the apex is a square root of a uniform number, because circumference grows with it.
vec3 sampleCone(float radius, float height, vec2 u) {
    float slant = sqrt(radius * radius + height * height);
    float baseShare = radius / (radius + slant);
    if (u.x < baseShare) {
        vec2 p = radius * warpToDisk(vec2(u.x / baseShare, u.y));
        return vec3(p.x, height, p.y);
    }
    float fromApex = sqrt((u.x - baseShare) / (1.0 - baseShare));
    vec2 sinCos = sinCosTwoPi(u.y);
    return fromApex * vec3(radius * sinCos.y, height, radius * sinCos.x);
}

LightSample sampleConeLight(Light light, vec3 shadingPoint, vec2 u) {
    Quadric cone = quadricOf(light, kCone);
    vec3 local = sampleCone(cone.radius, cone.extent, u);
    return closedQuadricSample(light, cone, local, shadingPoint);
}

float pdfOfConeLight(Light light, vec3 shadingPoint, LightPoint point) {
    return closedQuadricPdf(light, kCone, shadingPoint, point);
}

vec3 radianceOfConeLight(Light light, LightPoint point) { return areaLightRadiance(light, point); }

#endif
