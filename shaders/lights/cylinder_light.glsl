// A closed cylinder that emits, sampled by uniform points (docs/models.md, "Quadric lights").
#ifndef CALOTYPE_LIGHTS_CYLINDER_LIGHT_GLSL
#define CALOTYPE_LIGHTS_CYLINDER_LIGHT_GLSL

#include "core/warp.glsl"
#include "shared/scene_structs.h"

/// In the quadric's frame, on the side or one of the caps, chosen by area.
vec3 sampleCylinder(Quadric cylinder, vec2 u) {
    float radius = cylinder.radius;
    float height = cylinder.extent;
    float capShare = 0.5 * radius / (height + radius);
    bool lower = u.x < capShare;
    if (lower || u.x >= 1.0 - capShare) {
        float rest = (lower ? u.x : 1.0 - u.x) / capShare;
        vec2 p = radius * warpToDisk(vec2(min(rest, 1.0), u.y));
        return vec3(p.x, lower ? -0.5 * height : 0.5 * height, p.y);
    }
    float rest = (u.x - capShare) / (1.0 - 2.0 * capShare);
    vec2 sinCos = sinCosTwoPi(u.y);
    return vec3(radius * sinCos.y, (rest - 0.5) * height, radius * sinCos.x);
}

#endif
