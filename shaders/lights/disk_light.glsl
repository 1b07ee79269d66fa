// A disk that emits, sampled by uniform points (docs/models.md, "Quadric lights").
#ifndef CALOTYPE_LIGHTS_DISK_LIGHT_GLSL
#define CALOTYPE_LIGHTS_DISK_LIGHT_GLSL

#include "core/warp.glsl"
#include "shared/scene_structs.h"

/// In the quadric's frame.
vec3 sampleDisk(Quadric disk, vec2 u) {
    vec2 p = disk.radius * warpToDisk(u);
    return vec3(p.x, 0.0, p.y);
}

#endif
