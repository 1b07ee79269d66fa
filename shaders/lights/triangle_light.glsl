// Uniform points on a triangle (docs/models.md, "Triangle light").
#ifndef CALOTYPE_LIGHTS_TRIANGLE_LIGHT_GLSL
#define CALOTYPE_LIGHTS_TRIANGLE_LIGHT_GLSL

#include "core/warp.glsl"
#include "lights/area_light.glsl"
#include "shapes/triangle_point.glsl"
#include "shared/scene_structs.h"

LightSample sampleTriangleLight(Triangle triangle, float area, vec3 reference, vec2 u) {
    vec3 edge1 = triangle.v1 - triangle.v0;
    vec3 edge2 = triangle.v2 - triangle.v0;
    vec2 b = warpToTriangle(u);
    vec3 along1 = b.x * edge1;
    vec3 along2 = b.y * edge2;
    LightPoint point;
    point.position = triangle.v0 + (along1 + along2);
    point.normal = normalOf(triangle);
    point.error = triangleError(point.position, along1, along2, point.normal);
    point.wi = normalize(point.position - reference);
    point.coordinates = b;
    return LightSample(point, solidAnglePdf(area, reference, point.position, point.normal));
}

#endif
