// The contract of a kind of light.
//
// A file lights/<kind>_light.glsl declares, for light that reaches `shadingPoint` (of a kind of the
// sort UniformQuadric, only what lights/uniform_quadric_light.glsl says):
//
//   LightSample sample<Kind>Light(Light light, vec3 shadingPoint, vec2 u)
//       Chooses a direction towards the light; each component of u is uniform in [0, 1). u.y is a
//       multiple of 2^-24. u.x need not be one: the choice of the light made it (chooseLight). The
//       function has no loop, since only loops that count their passes (kernels/lane_rays.glsl) may
//       take many: llvmpipe ends the loops of a kernel after 65,535 passes.
//   float pdfOf<Kind>Light(Light light, vec3 shadingPoint, LightPoint point)
//       The density, per solid angle at `shadingPoint`, with which that function chooses `point`.
//       A ray found `point`.
//   vec3 radianceOf<Kind>Light(Light light, LightPoint point)
//       The radiance that arrives from `point`, W/(m^2 sr), if nothing blocks it.
//
// Kinds that have an area share lights/area_light.glsl. Kinds that are infinitely far away have the
// direction point.wi only. To add a kind: write its file, include it in lights/light.glsl (of the
// sort UniformQuadric: in lights/uniform_quadric_light.glsl), and give it a line LIGHT in
// shared/feature_table.h, from which these two call its functions.
#ifndef CALOTYPE_LIGHTS_LIGHT_SAMPLE_GLSL
#define CALOTYPE_LIGHTS_LIGHT_SAMPLE_GLSL

/// A point of a light, as a ray from a shading point finds it.
struct LightPoint {
    vec3 wi;          ///< unit direction from the shading point
    vec3 position;    ///< this and the fields below: only of lights that have an area
    float error;      ///< bound on the distance along `normal` from `position` to the true surface
    vec3 normal;      ///< of the front
    vec2 coordinates; ///< barycentrics on a triangle, texture coordinates on a quadric
};

struct LightSample {
    LightPoint point;
    float pdf; ///< per solid angle at the shading point; 0 if the point is not visible from it
};

/// A point on a light that a ray hit. The other fields are zero.
LightPoint lightPoint(vec3 wi, vec3 position, vec3 normal) {
    return LightPoint(wi, position, 0.0, normal, vec2(0.0));
}

/// A direction only: of a light that is infinitely far away.
LightPoint pointAtInfinity(vec3 wi) { return LightPoint(wi, vec3(0.0), 0.0, vec3(0.0), vec2(0.0)); }

#endif
