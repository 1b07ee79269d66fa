#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <variant>

#include "scene/scene.h"

namespace calotype {

/// All texture slots of a material.
constexpr std::array<uint32_t Material::*, 5> kMaterialTextures = {
    &Material::colorTexture, &Material::roughnessTexture, &Material::specularTexture,
    &Material::normalMap, &Material::alphaTexture};

inline bool hasTextures(const Material& material) {
    return std::ranges::any_of(kMaterialTextures, [&](uint32_t Material::*slot) {
        return material.*slot != Material::kNoTexture;
    });
}

/// Whether the alpha of the image of a material's colours weighs their texels when they are
/// filtered: where the material has holes, the colour of a transparent texel has no meaning, and is
/// often black. A material that ignores alpha has no holes.
inline bool hasCutOutColors(const Material& material, std::span<const Texture> textures) {
    if (material.colorTexture == Material::kNoTexture ||
        material.alphaTexture == Material::kNoTexture)
        return false;
    const auto* image = std::get_if<ImageTexture>(&textures[material.colorTexture].source);
    return image != nullptr && image->image->isTransparent;
}

} // namespace calotype
