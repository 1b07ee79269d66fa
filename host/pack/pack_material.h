#pragma once

#include "pack/pack_textures.h"
#include "pack/scene_features.h"
#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace calotype {

/// Packs a material as the lobes that it consists of. Adds the kernel features that they need to
/// `features`, and the textures in use to `textures`.
shared::Material packMaterial(const Material& material, std::span<const Texture> sceneTextures,
                              TexturePacker& textures, SceneFeatures& features);

/// True where light may pass through surfaces of the material.
bool isTransparent(const Material& material);

} // namespace calotype
