// The material at a point of a surface.
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

/// Multiplies the material's numbers by its textures, and applies its normal map to the shading
/// normal.
void applyTextures(inout Material material, inout Interaction surface) {
    vec2 uv = hasTextures ? surface.coordinates.uv : vec2(0.0);
    if (hasColorTextures && material.colorTexture != kNone)
        material.color *= clamp(sampleTexture(material.colorTexture, uv, true).rgb, 0.0, 1.0);
    if (hasNormalMaps && material.normalMap != kNone) {
        vec3 texel = sampleTexture(material.normalMap, uv, false).rgb;
        surface.ns = mappedNormal(texel, surface.ns, surface.coordinates.dpdu,
                                  surface.coordinates.dpdv, surface.ng);
    }
    if (hasRoughnessTextures && material.roughnessTexture != kNone)
        material.roughness *=
            clamp(sampleTexture(material.roughnessTexture, uv, false).r, 0.0, 1.0);
    if (hasSpecularTextures && material.specularTexture != kNone)
        material.specular *= clamp(sampleTexture(material.specularTexture, uv, false).r, 0.0, 1.0);
}

/// The colour of the lobes of a material whose textures are looked up: a metal's F0, the
/// reflectance of any other opaque material, 1 for a clear one.
vec3 surfaceAlbedo(Material material) {
    return (material.lobes & kColorIsTint) != 0u ? vec3(1.0) : material.color;
}

#endif
