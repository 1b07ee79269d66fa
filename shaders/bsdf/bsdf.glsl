// The closed list of lobes, and how a material mixes them: a diffuse lobe, one of half vectors,
// both, or a dielectric boundary.
#ifndef CALOTYPE_BSDF_BSDF_GLSL
#define CALOTYPE_BSDF_BSDF_GLSL

#include "bsdf/blinn_phong.glsl"
#include "bsdf/dielectric.glsl"
#include "bsdf/diffuse.glsl"
#include "bsdf/ggx.glsl"
#include "bsdf/shading_normal.glsl"
#include "config/features.glsl"
#include "core/frame.glsl"
#include "core/select.glsl"
#include "shared/limits.h"
#include "shared/scene_structs.h"

/// What a material's parameters are at a point: its textures are looked up.
struct SurfaceParameters {
    uint lobes; ///< as in Material
    vec3 color;
    float roughness;
    float specular;
    float kd;
    float exponent;
    float eta; ///< inside over outside
};

/// A material at a point, seen from `wo`. All normals are turned to the viewer.
struct Bsdf {
    uint lobes;
    vec3 diffuse; ///< reflectance of the diffuse lobe; the tint of a dielectric
    GgxLobe ggx;
    BlinnPhongLobe blinnPhong;
    float eta;                ///< of a dielectric: far side over the viewer's
    float diffuseProbability; ///< with which the diffuse lobe is sampled
    bool isMirror;            ///< the GGX lobe is so narrow that it reflects one direction
    vec3 ng;
    vec3 horizon; ///< normal of the plane below which nothing is reflected
    vec3 wo;      ///< in the shading frame
    mat3 worldFromShading;
};

struct BsdfValue {
    vec3 value; ///< f |cos|
    float pdf;  ///< per solid angle, of the mixture of all lobes that have a density
};

struct BsdfSample {
    vec3 wi;      ///< in the world
    vec3 weight;  ///< f |cos| / pdf; zero where nothing is reflected
    float pdf;    ///< per solid angle; kSpecularPdf for a direction that is certain
    bool crosses; ///< wi goes to the far side
};

/// Stands for the infinite density of a specular direction: beside it any other strategy's
/// vanishes.
const float kSpecularPdf = 1e30;

/// Share of the samples for the diffuse lobe: by what either lobe reflects. The report's rule for
/// Blinn-Phong, kd / (kd + ks), and the like with the Fresnel term for GGX.
float probabilityOfDiffuse(vec3 diffuse, vec3 specular) {
    float d = greatest(diffuse);
    float s = greatest(specular);
    return d + s > 0.0 ? d / (d + s) : 1.0;
}

/// `horizon` is the normal below which light is cut off: ng, or the interpolated normal where rays
/// leave from the smooth surface.
Bsdf makeBsdf(SurfaceParameters surface, vec3 ng, vec3 ns, vec3 horizon, vec3 woWorld) {
    bool outside = dot(woWorld, ng) >= 0.0;
    float side = outside ? 1.0 : -1.0;
    Bsdf bsdf;
    bsdf.lobes = surface.lobes;
    bsdf.ng = side * ng;
    bsdf.horizon = side * horizon;
    vec3 shadingNormal =
        hasShadingNormals ? consistentNormal(woWorld, bsdf.ng, side * ns) : bsdf.ng;
    bsdf.worldFromShading = worldFromLocal(shadingNormal);
    vec3 wo = woWorld * bsdf.worldFromShading;
    // A cosine: the sum of three products is off by gamma_3 (4e-7) at most, and the frame's axes by
    // as much again, so a view along the surface may come out below it by less than 1e-6.
    bsdf.wo = vec3(wo.xy, greater(wo.z, 1e-6));
    bsdf.diffuse = surface.color;
    bsdf.diffuseProbability = 1.0;
    bsdf.isMirror = false;
    bsdf.eta = outside ? surface.eta : 1.0 / surface.eta;
    if (hasGgx && (surface.lobes & kLobeGgx) != 0u) {
        bool isMetal = (surface.lobes & kColorIsF0) != 0u;
        float k = (surface.roughness + 1.0) * (surface.roughness + 1.0) * 0.125;
        bsdf.ggx.f0 = isMetal ? surface.color : vec3(surface.specular);
        bsdf.ggx.alpha = surface.roughness * surface.roughness;
        bsdf.ggx.maskingK = (surface.lobes & kSmithMasking) != 0u ? -1.0 : k;
        bsdf.isMirror = hasMirrors && bsdf.ggx.alpha < kMirrorAlpha;
        bsdf.diffuse = isMetal ? vec3(0.0) : (1.0 - surface.specular) * surface.color;
        bsdf.diffuseProbability =
            probabilityOfDiffuse(bsdf.diffuse, fresnelSchlick(bsdf.ggx.f0, bsdf.wo.z));
    }
    if (hasBlinnPhong && (surface.lobes & kLobeBlinnPhong) != 0u) {
        bsdf.blinnPhong = BlinnPhongLobe(surface.specular, surface.exponent,
                                         (surface.lobes & kNormalizedLobe) != 0u);
        bsdf.diffuse = surface.kd * surface.color;
        bsdf.diffuseProbability = probabilityOfDiffuse(bsdf.diffuse, vec3(surface.specular));
    }
    return bsdf;
}

/// True where light arrives from one or two certain directions only, which no light sample meets.
bool isSpecular(Bsdf bsdf) {
    return (hasDielectrics && (bsdf.lobes & kLobeDielectric) != 0u) ||
           (hasMirrors && bsdf.isMirror && bsdf.diffuseProbability == 0.0);
}

/// For a direction in the world. Specular light has no value at any direction.
BsdfValue evaluateBsdf(Bsdf bsdf, vec3 wiWorld) {
    vec3 wi = wiWorld * bsdf.worldFromShading;
    BsdfValue result = BsdfValue(vec3(0.0), 0.0);
    if (wi.z <= 0.0 || dot(wiWorld, bsdf.horizon) <= 0.0)
        return result;
    // wo.h, as half of |wo + wi|: where both graze from opposite sides the dot product's sign is
    // noise.
    vec3 sum = bsdf.wo + wi;
    float cosThetaD = 0.5 * length(sum);
    vec3 h = normalize(sum);
    if (hasDiffuse && (bsdf.lobes & kLobeDiffuse) != 0u) {
        result.value = evaluateDiffuse(bsdf.diffuse, wi);
        result.pdf = bsdf.diffuseProbability * diffusePdf(wi);
    }
    if (hasGgx && (bsdf.lobes & kLobeGgx) != 0u && !bsdf.isMirror) {
        result.value += evaluateGgx(bsdf.ggx, bsdf.wo, wi, h, cosThetaD);
        result.pdf += (1.0 - bsdf.diffuseProbability) * ggxPdf(bsdf.ggx, bsdf.wo, h);
    }
    if (hasBlinnPhong && (bsdf.lobes & kLobeBlinnPhong) != 0u) {
        result.value += evaluateBlinnPhong(bsdf.blinnPhong, bsdf.wo, wi, h, cosThetaD);
        result.pdf +=
            (1.0 - bsdf.diffuseProbability) * blinnPhongPdf(bsdf.blinnPhong, h, cosThetaD);
    }
    return result;
}

/// The direction mirrored at a half vector drawn by the material's lobe, in the shading frame.
vec3 sampleHalfVectorLobe(Bsdf bsdf, vec2 u) {
    vec3 h = vec3(0.0, 0.0, 1.0);
    if (hasGgx && (bsdf.lobes & kLobeGgx) != 0u && !bsdf.isMirror)
        h = sampleGgx(bsdf.ggx, bsdf.wo, u);
    if (hasBlinnPhong && (bsdf.lobes & kLobeBlinnPhong) != 0u)
        h = sampleBlinnPhong(bsdf.blinnPhong, u);
    return 2.0 * dot(bsdf.wo, h) * h - bsdf.wo;
}

/// Mirrored light, in the world, belongs on the near side of the true surface and refracted light
/// on the far one: where rounding or a shading normal leave it on the other, it is mirrored there.
BsdfSample crossDielectric(Bsdf bsdf, float u) {
    DielectricSample event = sampleDielectric(bsdf.diffuse, bsdf.eta, bsdf.wo, u);
    bool crosses = event.wi.z < 0.0;
    vec3 wi = ontoSideOf(crosses ? -bsdf.ng : bsdf.ng, bsdf.worldFromShading * event.wi);
    return BsdfSample(wi, event.weight, kSpecularPdf, crosses);
}

/// A direction by the lobes' chances: u.xy within the lobe, u.z the choice.
BsdfSample sampleBsdf(Bsdf bsdf, vec3 u) {
    if (hasDielectrics && (bsdf.lobes & kLobeDielectric) != 0u)
        return crossDielectric(bsdf, u.z);
    const bool hasHalfVectors = hasGgx || hasBlinnPhong;
    bool diffuse = !hasHalfVectors || u.z < bsdf.diffuseProbability;
    vec3 wi = vec3(0.0);
    if (hasDiffuse && diffuse)
        wi = sampleDiffuse(u.xy);
    if (hasHalfVectors && !diffuse)
        wi = sampleHalfVectorLobe(bsdf, u.xy);
    vec3 wiWorld = bsdf.worldFromShading * wi;
    if (hasMirrors && bsdf.isMirror && !diffuse)
        return BsdfSample(ontoSideOf(bsdf.ng, wiWorld),
                          mirrorWeight(bsdf.ggx, bsdf.wo.z) / (1.0 - bsdf.diffuseProbability),
                          kSpecularPdf, false);
    BsdfValue mixture = evaluateBsdf(bsdf, wiWorld);
    vec3 weight = mixture.pdf > 0.0 ? mixture.value / mixture.pdf : vec3(0.0);
    return BsdfSample(wiWorld, weight, mixture.pdf, false);
}

#endif
