#pragma once

#include <optional>

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// The value of the scene file's "textures".
JsonType texturesType();

/// Checks by the headers of the image files of "textures" that there is memory for them, and starts
/// to read them. Those that "materials" name, except for displacement, are uploaded to the device.
/// Throws like startTextures.
void requireMemoryForTextures(const JsonValue& textures, const std::optional<JsonValue>& materials,
                              JsonContext& context);

/// Reads the scene file's "textures" into Scene::textures, in the order of their names.
void readTextures(const JsonValue& value, JsonContext& context);

/// The index of the texture that `reference` names. Throws SceneError if there is none.
uint32_t findTexture(const JsonValue& reference, const JsonContext& context);

/// The same for an image; Material::kNoTexture if its file is missing.
uint32_t findImage(const JsonValue& reference, const JsonContext& context);

} // namespace calotype
