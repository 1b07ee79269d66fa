// A smooth boundary between two dielectrics: mirrored and refracted light in the proportions of the
// exact Fresnel equations (report eq. 1.34 with its "weighted sum"), one of them chosen by its
// share. Directions are in the shading frame; z is on the viewer's side.
#ifndef CALOTYPE_BSDF_DIELECTRIC_GLSL
#define CALOTYPE_BSDF_DIELECTRIC_GLSL

#include "bsdf/fresnel.glsl"

struct DielectricSample {
    vec3 wi;
    vec3 weight;
};

/// `eta` is the index of refraction on the far side over that on the viewer's; `tint` colours what
/// crosses. Radiance beyond the boundary is spread over another solid angle: crossing scales it by
/// (1 / eta)^2.
DielectricSample sampleDielectric(vec3 tint, float eta, vec3 wo, float u) {
    Refraction refraction = refractDielectric(wo, eta);
    if (u < refraction.reflectance)
        return DielectricSample(vec3(-wo.xy, wo.z), vec3(1.0));
    return DielectricSample(vec3(-wo.xy / eta, -refraction.cosThetaT), tint / (eta * eta));
}

#endif
