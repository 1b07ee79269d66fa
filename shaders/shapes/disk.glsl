// Disk of radius r about the origin in the plane y = 0, seen from both sides. The hit keeps x and z
// of the ray and y = 0 exactly; an origin within rounding of the plane does not meet it.
#ifndef CALOTYPE_SHAPES_DISK_GLSL
#define CALOTYPE_SHAPES_DISK_GLSL

#include "core/constants.glsl"
#include "shapes/local_ray.glsl"

/// Parameter of the crossing, or kFar.
float intersectDisk(LocalRay ray, float radius) {
    bool onPlane = abs(ray.origin.y) <= ray.error.y || ray.direction.y == 0.0;
    float t = onPlane ? 0.0 : -ray.origin.y / ray.direction.y;
    vec2 p = ray.origin.xz + t * ray.direction.xz;
    return t > 0.0 && dot(p, p) <= radius * radius ? t : kFar;
}

#endif
