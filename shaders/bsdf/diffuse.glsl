// Lambertian reflection, f = color / pi (report eq. 1.21), sampled by the cosine (eq. 1.22, 1.23).
// Directions are in the shading frame (z is ns, turned to the viewer's side).
#ifndef CALOTYPE_BSDF_DIFFUSE_GLSL
#define CALOTYPE_BSDF_DIFFUSE_GLSL

#include "core/warp.glsl"

vec3 evaluateDiffuse(vec3 color, vec3 wi) { return wi.z > 0.0 ? color * kInvPi : vec3(0.0); }

/// Per solid angle.
float diffusePdf(vec3 wi) { return cosineHemispherePdf(max(wi.z, 0.0)); }

vec3 sampleDiffuse(vec2 u) { return warpToCosineHemisphere(u); }

#endif
