#include "pack/pack_material.h"

#include "materials/material_kind.h"
#include "scene/material_textures.h"
#include "shared/limits.h"

namespace calotype {
namespace {

// The bits of the lobes must be below those of the flags.
#define LOBE(id, member, people) static_assert(shared::kLobe##id < shared::kColorIsF0);
#include "shared/feature_table.h"

bool mayBeMirror(const Material& material) {
    const double alpha = material.roughness * material.roughness;
    return alpha < shared::kMirrorAlpha || material.roughnessTexture != Material::kNoTexture;
}

/// The place of each of a material's textures, and the kernel feature that reads it there.
struct PackedSlot {
    uint32_t Material::*texture;
    uint32_t shared::Material::*packed;
    uint32_t feature;
    bool isOfEveryKind; ///< false: only of kinds that have it as a parameter
};
constexpr PackedSlot kSlots[] = {
    {&Material::colorTexture, &shared::Material::colorTexture, shared::kFeatureColorTextures, true},
    {&Material::roughnessTexture, &shared::Material::roughnessTexture,
     shared::kFeatureRoughnessTextures, false},
    {&Material::specularTexture, &shared::Material::specularTexture,
     shared::kFeatureSpecularTextures, false},
    {&Material::normalMap, &shared::Material::normalMap, shared::kFeatureNormalMaps, true},
    {&Material::alphaTexture, &shared::Material::alphaTexture, shared::kFeatureAlpha, true},
};
static_assert(std::ranges::equal(kSlots, kMaterialTextures, {}, &PackedSlot::texture));

/// Whether the kind has a parameter that can be this texture.
bool hasParameter(const MaterialKind& kind, uint32_t Material::*texture) {
    return std::ranges::any_of(kind.parameters, [&](const MaterialParameter& parameter) {
        const auto* number = std::get_if<NumberParameter>(&parameter.value);
        return number && number->texture == texture;
    });
}

/// Sets the packed index of texture slots, and the kernel features that they need.
class SlotPacker {
public:
    SlotPacker(std::span<const Texture> sceneTextures, TexturePacker& textures,
               SceneFeatures& features)
        : sceneTextures_(sceneTextures), textures_(textures), features_(features) {}

    uint32_t pack(uint32_t texture, uint32_t slotFeature, bool isCutOut) {
        if (texture == Material::kNoTexture)
            return shared::kNone;
        features_.enabled[slotFeature] = true;
        const auto* image = std::get_if<ImageTexture>(&sceneTextures_[texture].source);
        features_.enabled[!image                       ? shared::kFeatureCheckers
                          : image->image->holdsBytes() ? shared::kFeatureByteTexels
                                                       : shared::kFeatureFloatTexels] = true;
        if (isCutOut)
            features_.enabled[shared::kFeatureCutOutColors] = true;
        return textures_.add(texture, isCutOut);
    }

private:
    std::span<const Texture> sceneTextures_;
    TexturePacker& textures_;
    SceneFeatures& features_;
};

} // namespace

shared::Material packMaterial(const Material& material, std::span<const Texture> sceneTextures,
                              TexturePacker& textures, SceneFeatures& features) {
    shared::Material packed{};
    packed.color = glm::vec3(material.color);
    packed.roughness = static_cast<float>(material.roughness);
    packed.specular = static_cast<float>(material.specular);
    packed.opacity = static_cast<float>(material.opacity);
    packed.kd = static_cast<float>(material.kd);
    packed.exponent = static_cast<float>(material.exponent);
    packed.eta = static_cast<float>(material.ior / material.exteriorIor);
    const MaterialKind& kind = kindOf(material);
    kind.pack(material, packed);

    const bool hasGgx = (packed.lobes & shared::kLobeGgx) != 0;
    const auto enable = [&](uint32_t feature, bool needed) {
        features.enabled[feature] = features.enabled[feature] || needed;
    };
#define LOBE(id, member, people)                                                                   \
    enable(shared::kFeature##id, (packed.lobes & shared::kLobe##id) != 0);
#include "shared/feature_table.h"
    enable(shared::kFeatureMirrors, hasGgx && mayBeMirror(material));
    enable(shared::kFeatureAlpha, isTransparent(material));

    SlotPacker slots(sceneTextures, textures, features);
    for (const PackedSlot& slot : kSlots) {
        const bool isRead = slot.isOfEveryKind || hasParameter(kind, slot.texture);
        const bool isCutOut =
            slot.texture == &Material::colorTexture && hasCutOutColors(material, sceneTextures);
        packed.*slot.packed = slots.pack(isRead ? material.*slot.texture : Material::kNoTexture,
                                         slot.feature, isCutOut);
    }
    return packed;
}

bool isTransparent(const Material& material) {
    return material.opacity < 1.0 || material.alphaTexture != Material::kNoTexture;
}

} // namespace calotype
