// Uniform points on a disk (docs/models.md, "Quadric lights").
#ifndef CALOTYPE_LIGHTS_DISK_LIGHT_GLSL
#define CALOTYPE_LIGHTS_DISK_LIGHT_GLSL

#include "core/warp.glsl"

/// In the quadric's frame.
vec3 sampleDisk(float radius, vec2 u) {
    vec2 p = radius * warpToDisk(u);
    return vec3(p.x, 0.0, p.y);
}

#endif
