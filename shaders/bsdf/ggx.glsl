// Reflection by a rough surface of GGX microfacets (docs/models.md, "GGX" and "GGX masking"):
// f = D F G / (4 cosO cosI).
//
// D is written with the square of the tangent, D = 1 / (pi alpha^2 (tan^2 / alpha^2 + 1)^2 cos^4),
// since the usual form cancels for small alpha. Masking is Schlick's product of two factors or
// Smith's height-correlated term (Heitz 2014, "Understanding the Masking-Shadowing Function", eq.
// 99). Schlick's, divided by 4 cosO cosI, needs no division by small cosines.
//
// Half vectors are sampled among those visible to the viewer (Dupuy and Benyoub 2023, "Sampling
// Visible GGX Normals with Spherical Caps"), with density D G1 max(0, wo.h) / cosO; the Jacobian 1
// / (4 wo.h) turns it into a density of directions. Unlike with the density D cos, weights stay
// below one, also at grazing views.
//
// A lobe that is too narrow to sample is a mirror (docs/models.md, "Mirror"), which is specular.
#ifndef CALOTYPE_BSDF_GGX_GLSL
#define CALOTYPE_BSDF_GGX_GLSL

#include "bsdf/fresnel.glsl"
#include "bsdf/half_vector.glsl"
#include "bsdf/lobe.glsl"
#include "config/features.glsl"
#include "core/constants.glsl"
#include "core/select.glsl"
#include "core/trigonometry.glsl"
#include "shared/limits.h"
#include "shared/scene_structs.h"

const bool kGgxMayBeSpecular = hasMirrors;
const bool kGgxCrosses = false;
const bool kGgxCrossesWithDensity = false;

struct GgxLobe {
    vec3 f0;
    float alpha;    ///< roughness^2
    float maskingK; ///< of Schlick's masking: (roughness + 1)^2 / 8; negative selects Smith's term
    bool isMirror;
};

GgxLobe makeGgx(Material material) {
    bool isMetal = (material.lobes & kColorIsF0) != 0u;
    float k = (material.roughness + 1.0) * (material.roughness + 1.0) * 0.125;
    GgxLobe lobe;
    lobe.f0 = isMetal ? material.color : vec3(material.specular);
    lobe.alpha = material.roughness * material.roughness;
    lobe.maskingK = (material.lobes & kSmithMasking) != 0u ? -1.0 : k;
    lobe.isMirror = hasMirrors && lobe.alpha < kMirrorAlpha;
    return lobe;
}

bool isSpecular(GgxLobe lobe) { return hasMirrors && lobe.isMirror; }

float lobeAlbedo(GgxLobe lobe, vec3 wo) { return greatest(fresnelSchlick(lobe.f0, wo.z)); }

/// Density of microfacet normals for a unit half vector h.
float ggxD(vec3 h, float alpha) {
    float t = dot(h.xy, h.xy) / (alpha * alpha) + h.z * h.z;
    return 1.0 / (kPi * alpha * alpha * t * t);
}

/// sqrt(alpha^2 + (1 - alpha^2) cos^2), which is cos (1 + 2 Lambda) in Heitz's terms.
float ggxSlantCosine(float cosTheta, float alpha) {
    float a2 = alpha * alpha;
    return sqrt(a2 + (1.0 - a2) * cosTheta * cosTheta);
}

/// G / (4 cosO cosI).
float ggxVisibility(float cosThetaO, float cosThetaI, GgxLobe lobe) {
    float k = lobe.maskingK;
    float schlick = 0.25 / ((cosThetaO * (1.0 - k) + k) * (cosThetaI * (1.0 - k) + k));
    float smith = 0.5 / (cosThetaI * ggxSlantCosine(cosThetaO, lobe.alpha) +
                         cosThetaO * ggxSlantCosine(cosThetaI, lobe.alpha));
    return k < 0.0 ? smith : schlick;
}

vec3 evaluateLobe(GgxLobe lobe, vec3 wo, vec3 wi) {
    HalfVector middle = halfVectorOf(wo, wi);
    vec3 fresnel = fresnelSchlick(lobe.f0, middle.cosThetaD);
    vec3 value = fresnel * (ggxD(middle.h, lobe.alpha) * ggxVisibility(wo.z, wi.z, lobe) * wi.z);
    return wi.z > 0.0 && !isSpecular(lobe) ? value : vec3(0.0);
}

/// G1(wo) D / (4 cosO), where cosO cancels.
float lobePdf(GgxLobe lobe, vec3 wo, vec3 wi) {
    vec3 h = halfVectorOf(wo, wi).h;
    float pdf = 0.5 * ggxD(h, lobe.alpha) / (wo.z + ggxSlantCosine(wo.z, lobe.alpha));
    return wi.z > 0.0 && !isSpecular(lobe) ? pdf : 0.0;
}

/// Samples a visible half vector. In the space where the surface is a hemisphere, it is wo plus s,
/// a point on the spherical cap about wo that reflects into the upper side. The point's z is (1 -
/// u) (1 + s.z) - s.z. From there, 1 - z, 1 + z and z + s.z are written without differences, which
/// would lose the lobe's far end (u near 1) to rounding.
vec3 sampleVisibleHalfVector(GgxLobe lobe, vec3 wo, vec2 u) {
    vec3 stretched = normalize(vec3(lobe.alpha * wo.xy, wo.z));
    vec2 sinCosPhi = sinCosTwoPi(u.x);
    float height = (1.0 - u.y) * (1.0 + stretched.z);
    float onePlusZ = height + dot(stretched.xy, stretched.xy) / (1.0 + stretched.z);
    float sinTheta = sqrt(u.y * (1.0 + stretched.z) * onePlusZ);
    vec2 h = sinTheta * sinCosPhi.yx + stretched.xy;
    return normalize(vec3(lobe.alpha * h, height));
}

/// F G1(wo)^2. In the limit Smith's term is 1.
vec3 mirrorWeight(GgxLobe lobe, float cosThetaO) {
    float k = lobe.maskingK;
    float g1 = k < 0.0 ? 1.0 : cosThetaO / (cosThetaO * (1.0 - k) + k);
    return fresnelSchlick(lobe.f0, cosThetaO) * (g1 * g1);
}

LobeSample sampleLobe(GgxLobe lobe, vec3 wo, vec3 u) {
    if (isSpecular(lobe))
        return LobeSample(vec3(-wo.xy, wo.z), true, mirrorWeight(lobe, wo.z), 1.0);
    return lobeSample(mirroredAt(sampleVisibleHalfVector(lobe, wo, u.xy), wo));
}

#endif
