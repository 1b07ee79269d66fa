// Disk of radius r about the origin in the plane y = 0, seen from both sides. The hit has x and z
// of the ray and y = 0 exactly. A ray that starts in the plane, up to rounding, misses it.
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
