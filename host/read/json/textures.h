#pragma once

#include "read/load_context.h"

namespace calotype {

/// The scene file's "textures" into Scene::textures, in the order of their names.
void readTextures(const JsonValue& value, LoadContext& context);

/// The index of the texture that `reference` names. Throws SceneError if there is none.
uint32_t findTexture(const JsonValue& reference, const LoadContext& context);

} // namespace calotype
