// The closed list of lobes, and the two frames that shading has to keep apart.
#ifndef CALOTYPE_BSDF_BSDF_GLSL
#define CALOTYPE_BSDF_BSDF_GLSL

#include "bsdf/diffuse.glsl"
#include "core/frame.glsl"
#include "shared/scene_structs.h"

/// A material at a point, seen from one side. Both normals are turned to the viewer; light that the
/// shading normal would let through the true surface is cut off by the geometric one.
struct Bsdf {
    vec3 color;
    vec3 ng;
    mat3 worldFromShading;
};

struct BsdfSample {
    vec3 wi;     ///< in the world
    vec3 weight; ///< f |cos| / pdf; zero where nothing is reflected
    float pdf;   ///< per solid angle
};

Bsdf makeBsdf(Material material, vec3 ng, vec3 ns, vec3 wo) {
    float side = dot(wo, ng) < 0.0 ? -1.0 : 1.0;
    return Bsdf(material.color, side * ng, worldFromLocal(side * ns));
}

/// f |cos|, in the world.
vec3 evaluateBsdf(Bsdf bsdf, vec3 wi) {
    vec3 local = wi * bsdf.worldFromShading;
    return dot(wi, bsdf.ng) > 0.0 ? evaluateDiffuse(bsdf.color, local) * abs(local.z) : vec3(0.0);
}

/// Per solid angle.
float bsdfPdf(Bsdf bsdf, vec3 wi) { return diffusePdf(wi * bsdf.worldFromShading); }

BsdfSample sampleBsdf(Bsdf bsdf, vec2 u) {
    vec3 local = sampleDiffuse(u);
    vec3 wi = bsdf.worldFromShading * local;
    vec3 weight = dot(wi, bsdf.ng) > 0.0 ? bsdf.color : vec3(0.0);
    return BsdfSample(wi, weight, diffusePdf(local));
}

#endif
