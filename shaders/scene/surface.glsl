// The material at a point of a surface, with all textures looked up.
#ifndef CALOTYPE_SCENE_SURFACE_GLSL
#define CALOTYPE_SCENE_SURFACE_GLSL

#include "bsdf/bsdf.glsl"
#include "bsdf/shading_normal.glsl"
#include "scene/interaction.glsl"
#include "scene/texture.glsl"

Material materialOf(Interaction surface) {
    return loadMaterial(surface.material & ~kTransparentBit);
}

/// The share of light that the surface scatters, in [0, 1]; the rest passes through.
float alphaAt(Material material, vec2 uv) {
    float alpha = material.opacity;
    if (hasTextures && material.alphaTexture != kNone)
        alpha *= sampleTexture(material.alphaTexture, uv, false).a;
    return alpha;
}

/// Looks up the material's textures, and applies its normal map to the shading normal.
SurfaceParameters surfaceParameters(Material material, inout Interaction surface) {
    vec2 uv = hasTextures ? surface.coordinates.uv : vec2(0.0);
    vec3 color = material.color;
    if (hasColorTextures && material.colorTexture != kNone)
        color *= clamp(sampleTexture(material.colorTexture, uv, true).rgb, 0.0, 1.0);
    if (hasNormalMaps && material.normalMap != kNone) {
        vec3 texel = sampleTexture(material.normalMap, uv, false).rgb;
        surface.ns = mappedNormal(texel, surface.ns, surface.coordinates.dpdu,
                                  surface.coordinates.dpdv, surface.ng);
    }
    float roughness = material.roughness;
    if (hasRoughnessTextures && material.roughnessTexture != kNone)
        roughness *= clamp(sampleTexture(material.roughnessTexture, uv, false).r, 0.0, 1.0);
    float specular = material.specular;
    if (hasSpecularTextures && material.specularTexture != kNone)
        specular *= clamp(sampleTexture(material.specularTexture, uv, false).r, 0.0, 1.0);
    return SurfaceParameters(material.lobes, color, roughness, specular, material.kd,
                             material.exponent, material.eta);
}

#endif
