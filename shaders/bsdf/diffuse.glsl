// Lambertian reflection (docs/models.md, "Lambert"): f = color / pi, sampled by the cosine.
#ifndef CALOTYPE_BSDF_DIFFUSE_GLSL
#define CALOTYPE_BSDF_DIFFUSE_GLSL

#include "bsdf/lobe.glsl"
#include "config/features.glsl"
#include "core/select.glsl"
#include "core/warp.glsl"
#include "shared/scene_structs.h"

const bool kDiffuseMayBeSpecular = false;
const bool kDiffuseCrosses = false;
const bool kDiffuseCrossesWithDensity = false;

struct DiffuseLobe {
    vec3 reflectance;
};

/// Under a GGX lobe the reflectance is what the lobe's F0 leaves ("Metal and nonmetal"); under
/// Blinn-Phong it is the share `kd`.
DiffuseLobe makeDiffuse(Material material) {
    vec3 reflectance = material.color;
    if (hasGgx && (material.lobes & kLobeGgx) != 0u)
        reflectance = (1.0 - material.specular) * material.color;
    if (hasBlinnPhong && (material.lobes & kLobeBlinnPhong) != 0u)
        reflectance = material.kd * material.color;
    return DiffuseLobe(reflectance);
}

bool isSpecular(DiffuseLobe lobe) { return false; }

float lobeAlbedo(DiffuseLobe lobe, vec3 wo) { return greatest(lobe.reflectance); }

vec3 evaluateLobe(DiffuseLobe lobe, vec3 wo, vec3 wi) {
    return wi.z > 0.0 ? lobe.reflectance * cosineHemispherePdf(wi.z) : vec3(0.0);
}

float lobePdf(DiffuseLobe lobe, vec3 wo, vec3 wi) {
    return wi.z > 0.0 ? cosineHemispherePdf(wi.z) : 0.0;
}

LobeSample sampleLobe(DiffuseLobe lobe, vec3 wo, vec3 u) {
    return lobeSample(warpToCosineHemisphere(u.xy));
}

#endif
