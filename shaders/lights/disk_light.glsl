// A disk that emits, sampled by uniform points (docs/models.md, "Quadric lights").
#ifndef CALOTYPE_LIGHTS_DISK_LIGHT_GLSL
#define CALOTYPE_LIGHTS_DISK_LIGHT_GLSL

#include "core/warp.glsl"
#include "lights/quadric_light.glsl"

/// In the quadric's frame.
vec3 sampleDisk(float radius, vec2 u) {
    vec2 p = radius * warpToDisk(u);
    return vec3(p.x, 0.0, p.y);
}

LightSample sampleDiskLight(Light light, vec3 shadingPoint, vec2 u) {
    Quadric disk = quadricOf(light, kDisk);
    LightPoint point = quadricLightPoint(disk, sampleDisk(disk.radius, u), shadingPoint);
    return LightSample(point, uniformPointPdf(light, shadingPoint, point));
}

float pdfOfDiskLight(Light light, vec3 shadingPoint, LightPoint point) {
    return uniformPointPdf(light, shadingPoint, point);
}

vec3 radianceOfDiskLight(Light light, LightPoint point) { return areaLightRadiance(light, point); }

#endif
