// The specular lobe of Blinn-Phong around the half vector (docs/models.md, "Blinn-Phong"): with h
// at the angle a from the normal, f = ks (n + 2) / (2 pi) cos^n a. Half vectors are drawn by theta
// = acos u^(1/(n+1)), with density (n + 1) / (2 pi) cos^n a; the Jacobian 1 / (4 wo.h) turns it
// into a density of directions.
//
// That form can reflect up to about 4 ks. The normalised one,
//   f = ks (n + 1) / (2 pi) cos^n a / (4 (wo.h) max(cosO, cosI)),
// is reciprocal, since wo.h = wi.h, and loses only the light that falls below the surface: over the
// half vectors f cosI becomes ks times their density times cosI / max(cosO, cosI), so at most ks.
//
// cos^n is exp(-n/2 log(1 + tan^2)): accurate up to n = 1e7, where pow(cos, n) is only noise.
#ifndef CALOTYPE_BSDF_BLINN_PHONG_GLSL
#define CALOTYPE_BSDF_BLINN_PHONG_GLSL

#include "bsdf/half_vector.glsl"
#include "bsdf/lobe.glsl"
#include "config/features.glsl"
#include "core/constants.glsl"
#include "core/exponential.glsl"
#include "core/trigonometry.glsl"
#include "shared/scene_structs.h"

const bool kBlinnPhongMayBeSpecular = false;
const bool kBlinnPhongCrosses = false;
const bool kBlinnPhongCrossesWithDensity = false;

struct BlinnPhongLobe {
    float ks;
    float exponent;
    bool isNormalized;
};

BlinnPhongLobe makeBlinnPhong(Material material) {
    return BlinnPhongLobe(material.specular, material.exponent,
                          (material.lobes & kNormalizedLobe) != 0u);
}

bool isSpecular(BlinnPhongLobe lobe) { return false; }

float lobeAlbedo(BlinnPhongLobe lobe, vec3 wo) { return lobe.ks; }

/// The density of half vectors, per solid angle of h.
float blinnPhongHalfPdf(float exponent, vec3 h) {
    float tan2 = dot(h.xy, h.xy) / (h.z * h.z);
    return (exponent + 1.0) / kTwoPi * exp(-0.5 * exponent * logOnePlus(tan2));
}

vec3 evaluateLobe(BlinnPhongLobe lobe, vec3 wo, vec3 wi) {
    HalfVector middle = halfVectorOf(wo, wi);
    float n = lobe.exponent;
    float scale =
        lobe.isNormalized ? 0.25 / (middle.cosThetaD * max(wo.z, wi.z)) : (n + 2.0) / (n + 1.0);
    float value = lobe.ks * blinnPhongHalfPdf(n, middle.h) * scale * wi.z;
    return vec3(wi.z > 0.0 ? value : 0.0);
}

float lobePdf(BlinnPhongLobe lobe, vec3 wo, vec3 wi) {
    HalfVector middle = halfVectorOf(wo, wi);
    float pdf = blinnPhongHalfPdf(lobe.exponent, middle.h) * 0.25 / middle.cosThetaD;
    return wi.z > 0.0 ? pdf : 0.0;
}

/// Uses 1 - u where the model has u, because it is never zero.
LobeSample sampleLobe(BlinnPhongLobe lobe, vec3 wo, vec3 u) {
    float minusLogU = logOnePlus(u.x / (1.0 - u.x));
    float tan2 = expMinusOne(2.0 * minusLogU / (lobe.exponent + 1.0));
    float cosTheta = inversesqrt(1.0 + tan2);
    float sinTheta = sqrt(tan2) * cosTheta;
    vec2 sinCosPhi = sinCosTwoPi(u.y);
    vec3 h = vec3(sinTheta * sinCosPhi.y, sinTheta * sinCosPhi.x, cosTheta);
    return lobeSample(mirroredAt(h, wo));
}

#endif
