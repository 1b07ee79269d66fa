#pragma once

#include "pack/pack_textures.h"
#include "pack/scene_features.h"
#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace calotype {

/// A material as the lobes that it is made of, and into `features` what they need of the kernel.
/// The textures in use are added to `textures`.
shared::Material packMaterial(const Material& material, std::span<const Texture> sceneTextures,
                              TexturePacker& textures, SceneFeatures& features);

/// True where light may pass through surfaces of the material.
bool isTransparent(const Material& material);

} // namespace calotype
