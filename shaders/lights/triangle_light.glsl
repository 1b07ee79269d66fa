// A triangle that emits, sampled by solid angle if it is often chosen and where single precision
// allows it, otherwise by uniform points (docs/models.md, "Triangle light").
#ifndef CALOTYPE_LIGHTS_TRIANGLE_LIGHT_GLSL
#define CALOTYPE_LIGHTS_TRIANGLE_LIGHT_GLSL

#include "buffers/packed_scene.glsl"
#include "config/features.glsl"
#include "core/warp.glsl"
#include "lights/area_light.glsl"
#include "shapes/spherical_triangle.glsl"
#include "shapes/triangle_point.glsl"
#include "shared/scene_structs.h"

/// `seen` is the light's triangle, from the shading point.
bool isSampledBySolidAngle(Light light, SphericalTriangle seen) {
    return hasSolidAngleLights && (light.flags & kLightBySolidAngle) != 0u &&
           canSampleSolidAngle(seen);
}

float trianglePdf(SphericalTriangle seen, Light light, vec3 shadingPoint, LightPoint point) {
    return isSampledBySolidAngle(light, seen) ? 1.0 / solidAngleOf(seen)
                                              : uniformPointPdf(light, shadingPoint, point);
}

float pdfOfTriangleLight(Light light, vec3 shadingPoint, LightPoint point) {
    Triangle triangle = loadTriangle(light.primitive);
    return trianglePdf(sphericalTriangle(triangle, light.area, shadingPoint), light, shadingPoint,
                       point);
}

LightSample sampleTriangleLight(Light light, vec3 shadingPoint, vec2 u) {
    Triangle triangle = loadTriangle(light.primitive);
    SphericalTriangle seen = sphericalTriangle(triangle, light.area, shadingPoint);
    vec2 b = isSampledBySolidAngle(light, seen) ? uniformInSolidAngle(seen, u) : warpToTriangle(u);
    vec3 along1 = b.x * (triangle.v1 - triangle.v0);
    vec3 along2 = b.y * (triangle.v2 - triangle.v0);
    LightPoint point;
    point.position = triangle.v0 + (along1 + along2);
    point.normal = normalOf(triangle);
    point.error = triangleError(point.position, along1, along2, point.normal);
    point.wi = normalize(point.position - shadingPoint);
    point.coordinates = b;
    return LightSample(point, trianglePdf(seen, light, shadingPoint, point));
}

vec3 radianceOfTriangleLight(Light light, LightPoint point) {
    return areaLightRadiance(light, point);
}

#endif
