// How a material scatters light at a point: the mixture of its lobes (docs/models.md, "Mixture of
// lobes"). Each LOBE below is expanded for every lobe of shared/feature_table.h.
#ifndef CALOTYPE_BSDF_BSDF_GLSL
#define CALOTYPE_BSDF_BSDF_GLSL

#include "bsdf/lobe.glsl"
#include "bsdf/lobes.glsl"
#include "bsdf/shading_normal.glsl"
#include "config/features.glsl"
#include "core/frame.glsl"
#include "core/select.glsl"

/// The part of [0, 1) that chooses this lobe.
struct LobeShare {
    float start;
    float chance; ///< its length: the probability with which the lobe is sampled
};

/// Where a number that chooses a lobe lies in its share, from 0 to 1.
float placeIn(LobeShare share, float u) { return (u - share.start) / share.chance; }

/// A material at a point, seen from `wo`. All normals are turned to the viewer.
struct Bsdf {
    uint lobes; ///< as in Material
#define LOBE(id, member, people)                                                                   \
    id##Lobe member;                                                                               \
    LobeShare member##Share;
#include "shared/feature_table.h"
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
    float total = 0.0;
#define LOBE(id, member, people)                                                                   \
    float member##Start = total;                                                                   \
    if (has##id && hasLobe(bsdf, kLobe##id))                                                       \
        total += lobeAlbedo(bsdf.member, bsdf.wo);                                                 \
    float member##End = total;
#include "shared/feature_table.h"
#define LOBE(id, member, people) bsdf.member##Share = lobeShare(member##Start, member##End, total);
#include "shared/feature_table.h"
}

/// The material's textures are looked up. `horizon` is the normal of the plane below which light is
/// cut off: ng, or the interpolated normal if rays start from the smooth surface.
Bsdf makeBsdf(Material material, vec3 ng, vec3 ns, vec3 horizon, vec3 woWorld) {
    bool isOutside = dot(woWorld, ng) >= 0.0;
    float side = isOutside ? 1.0 : -1.0;
    Bsdf bsdf;
    bsdf.lobes = material.lobes;
    bsdf.ng = side * ng;
    bsdf.horizon = side * horizon;
    vec3 shadingNormal =
        hasShadingNormals ? consistentNormal(woWorld, bsdf.ng, side * ns) : bsdf.ng;
    bsdf.worldFromShading = worldFromLocal(shadingNormal);
    vec3 wo = woWorld * bsdf.worldFromShading;
    // The error of this cosine: gamma_3 (4e-7) from the sum of three products, and as much from the
    // frame's axes. So a view along the surface may come out below it, by less than 1e-6.
    bsdf.wo = vec3(wo.xy, greater(wo.z, 1e-6));
    material.eta = isOutside ? material.eta : 1.0 / material.eta;
#define LOBE(id, member, people) bsdf.member = make##id(material);
#include "shared/feature_table.h"
    shareOut(bsdf);
    return bsdf;
}

/// True if the surface scatters to certain directions only, which light sampling never finds.
bool isSpecular(Bsdf bsdf) {
    bool hasDensity = false;
#define LOBE(id, member, people)                                                                   \
    if (has##id && hasLobe(bsdf, kLobe##id) && !isSpecular(bsdf.member))                           \
        hasDensity = hasDensity || bsdf.member##Share.chance > 0.0;
#include "shared/feature_table.h"
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
#define LOBE(id, member, people)                                                                   \
    if (has##id && hasLobe(bsdf, kLobe##id)) {                                                     \
        result.value += evaluateLobe(bsdf.member, bsdf.wo, wi);                                    \
        result.pdf += bsdf.member##Share.chance * lobePdf(bsdf.member, bsdf.wo, wi);               \
    }
#include "shared/feature_table.h"
    return result;
}

/// A sample of one lobe, and the probability of choosing that lobe.
struct ChosenSample {
    LobeSample scattered;
    float chance;
};

/// A direction from one lobe: u.z chooses the lobe, u.xy the direction; the place of u.z in the
/// lobe's share is a third number for it. The last lobe whose share does not start above u.z is
/// taken, so that rounding of the shares leaves no number without one.
ChosenSample sampleOneLobe(Bsdf bsdf, vec3 u) {
    ChosenSample chosen = ChosenSample(lobeSample(vec3(0.0)), 1.0);
#define LOBE(id, member, people)                                                                   \
    if (has##id && hasLobe(bsdf, kLobe##id) && !(u.z < bsdf.member##Share.start))                  \
        chosen = ChosenSample(                                                                     \
            sampleLobe(bsdf.member, bsdf.wo, vec3(u.xy, placeIn(bsdf.member##Share, u.z))),        \
            bsdf.member##Share.chance);
#include "shared/feature_table.h"
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
