#include "read/json/texture_slots.h"

#include "base/names.h"
#include "read/json/color.h"
#include "read/json/textures.h"

namespace calotype {
namespace {

bool canBeName(const std::string& text) { return !text.empty() && text.front() != '#'; }

} // namespace

uint32_t readTextureName(const JsonValue& value, const LoadContext& context) {
    if (!canBeName(value.text())) {
        value.fail("must be the name of a texture, not " + inQuotes(value.text()));
    }
    return findTexture(value, context);
}

uint32_t readImageName(const JsonValue& value, const LoadContext& context) {
    const uint32_t texture = readTextureName(value, context);
    if (!std::holds_alternative<ImageTexture>(context.scene.textures[texture].source)) {
        value.fail("must name a texture of the type \"image\"; " + inQuotes(value.text()) +
                   " is none");
    }
    return context.scene.textures[texture].isMissing ? Material::kNoTexture : texture;
}

ColorSlot readColorSlot(const JsonValue& value, const LoadContext& context) {
    if (value.json().is_string() && canBeName(value.text())) {
        return {.texture = readTextureName(value, context)};
    }
    return {.color = readReflectance(value)};
}

ScalarSlot readScalarSlot(const JsonValue& value, const LoadContext& context) {
    if (value.json().is_string()) {
        return {.texture = readTextureName(value, context)};
    }
    if (!value.json().is_number()) {
        value.fail("must be a number in [0, 1] or the name of a texture");
    }
    return {.number = value.numberIn(0.0, 1.0)};
}

} // namespace calotype
