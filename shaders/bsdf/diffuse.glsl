// Lambertian reflection, f = color / pi (report eq. 1.21), sampled by the cosine (eq. 1.22, 1.23).
// Directions are in the shading frame: z is the shading normal, on the viewer's side.
#ifndef CALOTYPE_BSDF_DIFFUSE_GLSL
#define CALOTYPE_BSDF_DIFFUSE_GLSL

#include "core/warp.glsl"

/// f cos, for wi.z > 0.
vec3 evaluateDiffuse(vec3 color, vec3 wi) { return color * cosineHemispherePdf(wi.z); }

/// Per solid angle, for wi.z > 0.
float diffusePdf(vec3 wi) { return cosineHemispherePdf(wi.z); }

vec3 sampleDiffuse(vec2 u) { return warpToCosineHemisphere(u); }

#endif
