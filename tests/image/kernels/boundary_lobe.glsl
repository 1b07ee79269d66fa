// A lobe in the place of the diffuse one: a rough boundary that reflects the share kd of what it
// scatters and transmits the rest, each by the cosine. No material of the program transmits with a
// density; the code that such a lobe needs is tested with this one. Included before all else, it
// replaces bsdf/diffuse.glsl, whose include guard it defines.
#ifndef CALOTYPE_BSDF_DIFFUSE_GLSL
#define CALOTYPE_BSDF_DIFFUSE_GLSL

#include "bsdf/lobe.glsl"
#include "core/select.glsl"
#include "core/warp.glsl"
#include "shared/scene_structs.h"

const bool kDiffuseMayBeSpecular = false;
const bool kDiffuseCrosses = true;
const bool kDiffuseCrossesWithDensity = true;

struct DiffuseLobe {
    vec3 color;
    float kd;
    float eta; ///< index of refraction on the far side over that on the viewer's
};

DiffuseLobe makeDiffuse(Material material) {
    return DiffuseLobe(material.color, material.kd, material.eta);
}

bool isSpecular(DiffuseLobe lobe) { return false; }

float lobeAlbedo(DiffuseLobe lobe, vec3 wo) { return greatest(lobe.color); }

float lobePdf(DiffuseLobe lobe, vec3 wo, vec3 wi) {
    return (wi.z > 0.0 ? lobe.kd : 1.0 - lobe.kd) * cosineHemispherePdf(abs(wi.z));
}

/// Crossing scales radiance by (1 / eta)^2, as in bsdf/dielectric.glsl.
vec3 evaluateLobe(DiffuseLobe lobe, vec3 wo, vec3 wi) {
    float scale = wi.z > 0.0 ? 1.0 : 1.0 / (lobe.eta * lobe.eta);
    return scale * lobePdf(lobe, wo, wi) * lobe.color;
}

LobeSample sampleLobe(DiffuseLobe lobe, vec3 wo, vec3 u) {
    LobeSample drawn = lobeSample(warpToCosineHemisphere(u.xy));
    if (u.z >= lobe.kd) {
        drawn.wi.z = -drawn.wi.z;
        drawn.eta = lobe.eta;
    }
    return drawn;
}

#endif
