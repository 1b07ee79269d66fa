#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

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

} // namespace calotype
