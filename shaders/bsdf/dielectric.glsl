// A smooth boundary between two dielectrics (docs/models.md, "Dielectric"). One of the reflected
// and the refracted direction is chosen, with probabilities from Fresnel's exact equations.
#ifndef CALOTYPE_BSDF_DIELECTRIC_GLSL
#define CALOTYPE_BSDF_DIELECTRIC_GLSL

#include "bsdf/fresnel.glsl"
#include "bsdf/lobe.glsl"
#include "config/features.glsl"
#include "shared/scene_structs.h"

const bool kDielectricMayBeSpecular = hasDielectric;
const bool kDielectricCrosses = hasDielectric;
const bool kDielectricCrossesWithDensity = false;

struct DielectricLobe {
    vec3 tint; ///< of the light that crosses the boundary
    float eta; ///< index of refraction on the far side over that on the viewer's
};

DielectricLobe makeDielectric(Material material) {
    return DielectricLobe(material.color, material.eta);
}

bool isSpecular(DielectricLobe lobe) { return true; }

float lobeAlbedo(DielectricLobe lobe, vec3 wo) { return 1.0; }

vec3 evaluateLobe(DielectricLobe lobe, vec3 wo, vec3 wi) { return vec3(0.0); }

float lobePdf(DielectricLobe lobe, vec3 wo, vec3 wi) { return 0.0; }

/// u.z chooses the direction. Crossing the boundary changes the solid angle, which scales radiance
/// by (1 / eta)^2.
LobeSample sampleLobe(DielectricLobe lobe, vec3 wo, vec3 u) {
    Refraction refraction = refractDielectric(wo, lobe.eta);
    if (u.z < refraction.reflectance)
        return LobeSample(vec3(-wo.xy, wo.z), true, vec3(1.0), 1.0);
    return LobeSample(vec3(-wo.xy / lobe.eta, -refraction.cosThetaT), true,
                      lobe.tint / (lobe.eta * lobe.eta), lobe.eta);
}

#endif
