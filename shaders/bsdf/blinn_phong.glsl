// The specular lobe of Blinn-Phong with a half vector at angle a from the normal:
// f = ks (n + 2) / (2 pi) cos^n a (report eq. 1.24), drawn by theta = acos u^(1/(n+1)) (eq. 1.25),
// whose density of half vectors (n + 1) / (2 pi) cos^n a (eq. 1.26) times the Jacobian 1 / (4 wo.h)
// is that of directions.
//
// That form reflects up to about 4 ks. The normalised one,
//   f = ks (n + 1) / (2 pi) cos^n a / (4 (wo.h) max(cosO, cosI)),
// is reciprocal, since wo.h = wi.h, and loses nothing but what falls below the surface: over the
// half vectors f cosI becomes ks times their density times cosI / max(cosO, cosI), so at most ks.
//
// cos^n is exp(-n/2 log(1 + tan^2)), which holds for exponents to 1e7, where pow(cos, n) is noise.
// Directions are in the shading frame; wo.z > 0.
#ifndef CALOTYPE_BSDF_BLINN_PHONG_GLSL
#define CALOTYPE_BSDF_BLINN_PHONG_GLSL

#include "core/constants.glsl"
#include "core/exponential.glsl"
#include "core/trigonometry.glsl"

struct BlinnPhongLobe {
    float ks;
    float exponent;
    bool normalized;
};

/// The density of half vectors, per solid angle of h.
float blinnPhongHalfPdf(float exponent, vec3 h) {
    float tan2 = dot(h.xy, h.xy) / (h.z * h.z);
    return (exponent + 1.0) / kTwoPi * exp(-0.5 * exponent * logOnePlus(tan2));
}

/// f cos, for wi.z > 0, h the unit half vector and cosThetaD its cosine to either direction.
float evaluateBlinnPhong(BlinnPhongLobe lobe, vec3 wo, vec3 wi, vec3 h, float cosThetaD) {
    float n = lobe.exponent;
    float scale = lobe.normalized ? 0.25 / (cosThetaD * max(wo.z, wi.z)) : (n + 2.0) / (n + 1.0);
    return lobe.ks * blinnPhongHalfPdf(n, h) * scale * wi.z;
}

/// Per solid angle of wi.
float blinnPhongPdf(BlinnPhongLobe lobe, vec3 h, float cosThetaD) {
    return blinnPhongHalfPdf(lobe.exponent, h) * 0.25 / cosThetaD;
}

/// A half vector; 1 - u takes the place of the report's u, as it is never zero.
vec3 sampleBlinnPhong(BlinnPhongLobe lobe, vec2 u) {
    float minusLogU = logOnePlus(u.x / (1.0 - u.x));
    float tan2 = expMinusOne(2.0 * minusLogU / (lobe.exponent + 1.0));
    float cosTheta = inversesqrt(1.0 + tan2);
    float sinTheta = sqrt(tan2) * cosTheta;
    vec2 sinCosPhi = sinCosTwoPi(u.y);
    return vec3(sinTheta * sinCosPhi.y, sinTheta * sinCosPhi.x, cosTheta);
}

#endif
