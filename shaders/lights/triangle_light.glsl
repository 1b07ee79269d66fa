// A triangle that emits, sampled by uniform points (docs/models.md, "Triangle light").
#ifndef CALOTYPE_LIGHTS_TRIANGLE_LIGHT_GLSL
#define CALOTYPE_LIGHTS_TRIANGLE_LIGHT_GLSL

#include "buffers/packed_scene.glsl"
#include "core/warp.glsl"
#include "lights/area_light.glsl"
#include "shapes/triangle_point.glsl"
#include "shared/scene_structs.h"

float pdfOfTriangleLight(Light light, vec3 shadingPoint, LightPoint point) {
    return uniformPointPdf(light, shadingPoint, point);
}

LightSample sampleTriangleLight(Light light, vec3 shadingPoint, vec2 u) {
    Triangle triangle = loadTriangle(light.primitive);
    vec3 edge1 = triangle.v1 - triangle.v0;
    vec3 edge2 = triangle.v2 - triangle.v0;
    vec2 b = warpToTriangle(u);
    vec3 along1 = b.x * edge1;
    vec3 along2 = b.y * edge2;
    LightPoint point;
    point.position = triangle.v0 + (along1 + along2);
    point.normal = normalOf(triangle);
    point.error = triangleError(point.position, along1, along2, point.normal);
    point.wi = normalize(point.position - shadingPoint);
    point.coordinates = b;
    return LightSample(point, pdfOfTriangleLight(light, shadingPoint, point));
}

vec3 radianceOfTriangleLight(Light light, LightPoint point) {
    return areaLightRadiance(light, point);
}

#endif
