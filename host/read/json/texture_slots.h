#pragma once

#include <glm/vec3.hpp>

#include "read/load_context.h"

namespace calotype {

/// What may stand where a material takes a colour: a colour, or a texture that replaces it, beside
/// which the colour is 1.
struct ColorSlot {
    glm::dvec3 color{1.0};
    uint32_t texture = Material::kNoTexture;
};

/// The same for a number in [0, 1]; of a texture, the first channel is read.
struct ScalarSlot {
    double number = 1.0;
    uint32_t texture = Material::kNoTexture;
};

/// All throw SceneError for what is neither, and for textures that are not there. Texts that start
/// with '#' are colours, never names.
ColorSlot readColorSlot(const JsonValue& value, const LoadContext& context);
ScalarSlot readScalarSlot(const JsonValue& value, const LoadContext& context);

/// The index of the texture that `value` names.
uint32_t readTextureName(const JsonValue& value, const LoadContext& context);

/// The same, of one that must be an image; Material::kNoTexture where its file is missing.
uint32_t readImageName(const JsonValue& value, const LoadContext& context);

} // namespace calotype
