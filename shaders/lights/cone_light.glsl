// A closed cone that emits, sampled by uniform points (docs/models.md, "Quadric lights").
#ifndef CALOTYPE_LIGHTS_CONE_LIGHT_GLSL
#define CALOTYPE_LIGHTS_CONE_LIGHT_GLSL

#include "core/warp.glsl"
#include "shared/scene_structs.h"

/// In the quadric's frame, on the side or the base, chosen by area. On the side the distance from
/// the apex is a square root of a uniform number, because circumference grows with it.
vec3 sampleCone(Quadric cone, vec2 u) {
    float radius = cone.radius;
    float height = cone.extent;
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

#endif
