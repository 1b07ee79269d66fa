// How a material scatters light at a point: the mixture of its lobes (docs/models.md, "Mixture of
// lobes").
#ifndef CALOTYPE_BSDF_BSDF_GLSL
#define CALOTYPE_BSDF_BSDF_GLSL

#include "bsdf/lobe.glsl"
#include "bsdf/lobes.glsl"
#include "bsdf/shading_normal.glsl"
#include "bsdf/surface_parameters.glsl"
#include "config/features.glsl"
#include "core/frame.glsl"
#include "core/select.glsl"

/// The part of [0, 1) in which the random number that chooses a lobe chooses this one.
struct LobeShare {
    float start;
    float chance; ///< its length: the probability with which the lobe is sampled
};

/// A material at a point, seen from `wo`. All normals are turned to the viewer.
struct Bsdf {
    uint lobes; ///< as in Material
    DiffuseLobe diffuse;
    GgxLobe ggx;
    BlinnPhongLobe blinnPhong;
    DielectricLobe dielectric;
    LobeShare diffuseShare;
    LobeShare ggxShare;
    LobeShare blinnPhongShare;
    LobeShare dielectricShare;
    vec3 ng;
    vec3 horizon; ///< normal of the plane below which nothing is reflected
    vec3 wo;      ///< in the shading frame
    mat3 worldFromShading;
};

struct BsdfValue {
    vec3 value; ///< f |cos|, of all lobes that have a density
    float pdf;  ///< per solid angle, of the mixture of these lobes
};

struct BsdfSample {
    vec3 wi;      ///< in world space
    vec3 weight;  ///< f |cos| / pdf; zero where nothing is scattered
    float pdf;    ///< per solid angle; kSpecularPdf for a specular direction
    bool crosses; ///< wi is on the far side
    float eta;    ///< as in LobeSample
};

/// Stands for the infinite density of a specular direction; every other density is negligible
/// beside it.
const float kSpecularPdf = 1e30;

bool hasLobe(Bsdf bsdf, uint lobe) { return (bsdf.lobes & lobe) != 0u; }

/// The share from `start` to `end`, both given as parts of `total`. If no lobe scatters anything,
/// all shares are empty. If an albedo is NaN, the shares and the sample's weight are NaN too: the
/// sample is then counted as lost, instead of being black without notice.
LobeShare lobeShare(float start, float end, float total) {
    float first = total == 0.0 ? 1.0 : start / total;
    float last = total == 0.0 ? 1.0 : end / total;
    return LobeShare(first, last - first);
}

/// Divides [0, 1) among the lobes in proportion to their albedos.
void shareOut(inout Bsdf bsdf) {
    float diffuse = 0.0, ggx = 0.0, blinnPhong = 0.0, dielectric = 0.0;
    if (hasDiffuse && hasLobe(bsdf, kLobeDiffuse))
        diffuse = lobeAlbedo(bsdf.diffuse, bsdf.wo);
    if (hasGgx && hasLobe(bsdf, kLobeGgx))
        ggx = lobeAlbedo(bsdf.ggx, bsdf.wo);
    if (hasBlinnPhong && hasLobe(bsdf, kLobeBlinnPhong))
        blinnPhong = lobeAlbedo(bsdf.blinnPhong, bsdf.wo);
    if (hasDielectrics && hasLobe(bsdf, kLobeDielectric))
        dielectric = lobeAlbedo(bsdf.dielectric, bsdf.wo);
    float ggxStart = diffuse;
    float blinnPhongStart = ggxStart + ggx;
    float dielectricStart = blinnPhongStart + blinnPhong;
    float total = dielectricStart + dielectric;
    bsdf.diffuseShare = lobeShare(0.0, ggxStart, total);
    bsdf.ggxShare = lobeShare(ggxStart, blinnPhongStart, total);
    bsdf.blinnPhongShare = lobeShare(blinnPhongStart, dielectricStart, total);
    bsdf.dielectricShare = lobeShare(dielectricStart, total, total);
}

/// `horizon` is the normal of the plane below which light is cut off: ng, or the interpolated
/// normal if rays start from the smooth surface.
Bsdf makeBsdf(SurfaceParameters surface, vec3 ng, vec3 ns, vec3 horizon, vec3 woWorld) {
    bool isOutside = dot(woWorld, ng) >= 0.0;
    float side = isOutside ? 1.0 : -1.0;
    Bsdf bsdf;
    bsdf.lobes = surface.lobes;
    bsdf.ng = side * ng;
    bsdf.horizon = side * horizon;
    vec3 shadingNormal =
        hasShadingNormals ? consistentNormal(woWorld, bsdf.ng, side * ns) : bsdf.ng;
    bsdf.worldFromShading = worldFromLocal(shadingNormal);
    vec3 wo = woWorld * bsdf.worldFromShading;
    // The error of this cosine: gamma_3 (4e-7) from the sum of three products, and as much from the
    // frame's axes. So a view along the surface may come out below it, by less than 1e-6.
    bsdf.wo = vec3(wo.xy, greater(wo.z, 1e-6));
    surface.eta = isOutside ? surface.eta : 1.0 / surface.eta;
    bsdf.diffuse = makeDiffuse(surface);
    bsdf.ggx = makeGgx(surface);
    bsdf.blinnPhong = makeBlinnPhong(surface);
    bsdf.dielectric = makeDielectric(surface);
    shareOut(bsdf);
    return bsdf;
}

/// True if the surface scatters to certain directions only, which light sampling never finds.
bool isSpecular(Bsdf bsdf) {
    bool hasDensity = hasDiffuse && hasLobe(bsdf, kLobeDiffuse) && bsdf.diffuseShare.chance > 0.0;
    hasDensity = hasDensity || (hasGgx && hasLobe(bsdf, kLobeGgx) && !isSpecular(bsdf.ggx));
    hasDensity = hasDensity || (hasBlinnPhong && hasLobe(bsdf, kLobeBlinnPhong));
    return !hasDensity;
}

/// Whether light may go in that direction: reflected light must leave above the shaded and the true
/// surface, transmitted light below both.
bool isScattered(Bsdf bsdf, vec3 wi, vec3 wiWorld) {
    bool isReflected = wi.z > 0.0 && dot(wiWorld, bsdf.horizon) > 0.0;
    bool isTransmitted = hasTransmission && wi.z < 0.0 && dot(wiWorld, bsdf.ng) < 0.0;
    return isReflected || isTransmitted;
}

/// `wiWorld` is in world space. Specular light has no value in any direction.
BsdfValue evaluateBsdf(Bsdf bsdf, vec3 wiWorld) {
    vec3 wi = wiWorld * bsdf.worldFromShading;
    BsdfValue result = BsdfValue(vec3(0.0), 0.0);
    if (!isScattered(bsdf, wi, wiWorld))
        return result;
    if (hasDiffuse && hasLobe(bsdf, kLobeDiffuse)) {
        result.value += evaluateLobe(bsdf.diffuse, bsdf.wo, wi);
        result.pdf += bsdf.diffuseShare.chance * lobePdf(bsdf.diffuse, bsdf.wo, wi);
    }
    if (hasGgx && hasLobe(bsdf, kLobeGgx)) {
        result.value += evaluateLobe(bsdf.ggx, bsdf.wo, wi);
        result.pdf += bsdf.ggxShare.chance * lobePdf(bsdf.ggx, bsdf.wo, wi);
    }
    if (hasBlinnPhong && hasLobe(bsdf, kLobeBlinnPhong)) {
        result.value += evaluateLobe(bsdf.blinnPhong, bsdf.wo, wi);
        result.pdf += bsdf.blinnPhongShare.chance * lobePdf(bsdf.blinnPhong, bsdf.wo, wi);
    }
    return result;
}

/// A sample of one lobe, and the probability of choosing that lobe.
struct ChosenSample {
    LobeSample scattered;
    float chance;
};

/// A direction from one lobe: u.z chooses the lobe, u.xy the direction. The last lobe whose share
/// starts at or below u.z is taken, so that rounding of the shares leaves no number without one.
ChosenSample sampleOneLobe(Bsdf bsdf, vec3 u) {
    ChosenSample chosen = ChosenSample(lobeSample(vec3(0.0)), 1.0);
    if (hasDiffuse && hasLobe(bsdf, kLobeDiffuse))
        chosen = ChosenSample(sampleLobe(bsdf.diffuse, bsdf.wo, u), bsdf.diffuseShare.chance);
    if (hasGgx && hasLobe(bsdf, kLobeGgx) && u.z >= bsdf.ggxShare.start)
        chosen = ChosenSample(sampleLobe(bsdf.ggx, bsdf.wo, u), bsdf.ggxShare.chance);
    if (hasBlinnPhong && hasLobe(bsdf, kLobeBlinnPhong) && u.z >= bsdf.blinnPhongShare.start)
        chosen = ChosenSample(sampleLobe(bsdf.blinnPhong, bsdf.wo, u), bsdf.blinnPhongShare.chance);
    if (hasDielectrics && hasLobe(bsdf, kLobeDielectric) && u.z >= bsdf.dielectricShare.start) {
        float place = (u.z - bsdf.dielectricShare.start) / bsdf.dielectricShare.chance;
        chosen = ChosenSample(sampleLobe(bsdf.dielectric, bsdf.wo, vec3(u.xy, place)),
                              bsdf.dielectricShare.chance);
    }
    return chosen;
}

/// A direction from the mixture: u.z chooses the lobe, u.xy the direction. Reflected specular light
/// must be on the near side of the true surface, transmitted light on the far side. If rounding or
/// a shading normal puts it on the wrong side, it is mirrored at the surface.
BsdfSample sampleBsdf(Bsdf bsdf, vec3 u) {
    ChosenSample chosen = sampleOneLobe(bsdf, u);
    LobeSample scattered = chosen.scattered;
    vec3 wi = bsdf.worldFromShading * scattered.wi;
    bool crosses = hasCrossing && scattered.wi.z < 0.0;
    if (hasSpecular && scattered.isSpecular)
        return BsdfSample(ontoSideOf(crosses ? -bsdf.ng : bsdf.ng, wi),
                          scattered.specularWeight / chosen.chance, kSpecularPdf, crosses,
                          scattered.eta);
    BsdfValue mixture = evaluateBsdf(bsdf, wi);
    vec3 weight = mixture.pdf == 0.0 ? vec3(0.0) : mixture.value / mixture.pdf;
    return BsdfSample(wi, weight, mixture.pdf, crosses, scattered.eta);
}

#endif
