#include "read/json/textures.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/names.h"
#include "read/json/color.h"
#include "read/texture_file.h"

namespace calotype {
namespace {

/// In the order of TextureWrap.
const std::array<std::string, 3> kWraps = {"repeat", "clamp", "mirror"};
/// In the order of TextureFilter.
const std::array<std::string, 2> kTextureFilters = {"bilinear", "nearest"};
const std::array<std::string, 2> kColorSpaces = {"srgb", "linear"};

JsonKey scaleKey(const char* description) {
    const JsonType scale = arrayType(numberType(ranges::kTextureScale), 2);
    return JsonKey("scale", namedType("textureScale", scale), description).orElseJson("[1, 1]");
}

enum TextureType { kImage, kChecker };

const JsonObjectTypes& textureTypes() {
    static const JsonObjectTypes types = {
        chosenType(
            "image", "An image file. v = 0 is its bottom.",
            {JsonKey("file", textType(),
                     "A file beside the scene file: PNG (8 or 16 bits), JPEG, TGA, BMP or "
                     "HDR, up to 16384 pixels on a side.")
                 .required(),
             JsonKey("wrap", choiceType(kWraps), "What lies outside [0, 1].")
                 .orElseJson("\"repeat\""),
             JsonKey("filter", choiceType(kTextureFilters), "What lies between texel centres.")
                 .orElseJson("\"bilinear\""),
             JsonKey("color_space", choiceType(kColorSpaces),
                     "srgb: colours decode images of 8 and 16 bits, and nothing else does; "
                     "linear prevents it.")
                 .orElseJson("\"srgb\""),
             scaleKey("How often the image repeats along u and v, from 0 to 1.")}),
        chosenType("checker", "Squares of two colours.",
                   {JsonKey("colors", arrayType(reflectanceType(), 2),
                            "The two colours; the first where floor(u sx) + floor(v sy) is even.")
                        .required(),
                    scaleKey("The number of squares along u and v, from 0 to 1.")})};
    return types;
}

ImageTexture readImage(const JsonObject& object, JsonContext& context) {
    ImageTexture image;
    image.wrap = static_cast<TextureWrap>(object.choice("wrap", kWraps, 0));
    image.filter = static_cast<TextureFilter>(object.choice("filter", kTextureFilters, 0));
    image.decodesColor = object.choice("color_space", kColorSpaces, 0) == 0;
    const JsonValue file = object.required("file");
    image.image = readTextureFile(file.text(), context.directory, file.where(), context).image;
    return image;
}

CheckerTexture readChecker(const JsonObject& object) {
    const std::vector<JsonValue> colors = object.required("colors").array(2);
    return {{readColor(colors[0], ranges::kShare), readColor(colors[1], ranges::kShare)}};
}

Texture readTexture(const JsonValue& value, const std::string& name, JsonContext& context) {
    const size_t type = readType(value, textureTypes());
    const JsonObject object(value, textureTypes()[type]);
    Texture texture;
    texture.name = name;
    if (const auto scale = object.optional("scale")) {
        const std::vector<JsonValue> factors = scale->array(2);
        texture.scale = {factors[0].number(), factors[1].number()};
    }
    if (type == kImage) {
        ImageTexture image = readImage(object, context);
        texture.isMissing = !image.image;
        if (texture.isMissing)
            image.image = magentaImage();
        texture.source = std::move(image);
    } else {
        texture.source = readChecker(object);
    }
    return texture;
}

/// Adds the texts in materials that may name textures on the device.
void addTexts(const nlohmann::json& value, std::set<std::string>& texts) {
    if (value.is_string())
        texts.insert(value.get<std::string>());
    if (value.is_object() || value.is_array())
        for (const auto& [key, child] : value.items())
            if (key != "displacement")
                addTexts(child, texts);
}

} // namespace

void requireMemoryForTextures(const JsonValue& textures, const std::optional<JsonValue>& materials,
                              JsonContext& context) {
    std::set<std::string> uploaded;
    if (materials)
        addTexts(materials->json(), uploaded);
    if (!textures.json().is_object())
        return;
    for (const auto& [name, texture] : textures.json().items())
        if (texture.is_object() && texture.contains("file") && texture["file"].is_string())
            countTexture(texture["file"].get<std::string>(), context.directory,
                         uploaded.contains(name), context);
    startTextures(context);
}

JsonType texturesType() { return objectMapType(anyOf(textureTypes(), "texture")); }

void readTextures(const JsonValue& value, JsonContext& context) {
    if (!value.json().is_object())
        value.fail("must be an object of textures by name");
    for (const std::string& name : namesInMap(value)) {
        context.addTexture(readTexture(value.child(name), name, context));
        context.textureNames.push_back(name);
    }
}

uint32_t findTexture(const JsonValue& reference, const JsonContext& context) {
    const auto& names = context.textureNames;
    const auto found = std::lower_bound(names.begin(), names.end(), reference.text());
    if (found == names.end() || *found != reference.text()) {
        reference.fail("there is no texture " + inQuotes(reference.text()) +
                       suggestion(reference.text(), names));
    }
    return static_cast<uint32_t>(found - names.begin());
}

uint32_t findImage(const JsonValue& reference, const JsonContext& context) {
    const uint32_t texture = findTexture(reference, context);
    if (!std::holds_alternative<ImageTexture>(context.scene.textures[texture].source)) {
        reference.fail("must name a texture of the type \"image\"; " + inQuotes(reference.text()) +
                       " is none");
    }
    return context.scene.textures[texture].isMissing ? Material::kNoTexture : texture;
}

} // namespace calotype
