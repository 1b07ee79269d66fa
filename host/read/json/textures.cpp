#include "read/json/textures.h"

#include <algorithm>
#include <array>

#include "base/names.h"
#include "read/json/color.h"
#include "read/texture_file.h"
#include "scene/uv_limit.h"

namespace calotype {
namespace {

const std::array<std::string, 2> kTypes = {"image", "checker"};
const std::array<std::string, 3> kWraps = {"repeat", "clamp", "mirror"};
const std::array<std::string, 2> kFilters = {"bilinear", "nearest"};
const std::array<std::string, 2> kColorSpaces = {"srgb", "linear"};
enum Type { kImage };

ImageTexture readImage(const JsonObject& object, LoadContext& context) {
    ImageTexture image;
    if (const auto wrap = object.optional("wrap")) {
        image.wrap = static_cast<TextureWrap>(wrap->choice(kWraps));
    }
    if (const auto filter = object.optional("filter")) {
        image.filter = static_cast<TextureFilter>(filter->choice(kFilters));
    }
    if (const auto space = object.optional("color_space")) {
        image.decodesColor = space->choice(kColorSpaces) == 0;
    }
    const JsonValue file = object.required("file");
    image.image = readTextureFile(file.text(), context.directory, file.where(), context).image;
    return image;
}

CheckerTexture readChecker(const JsonObject& object) {
    const std::vector<JsonValue> colors = object.required("colors").array(2);
    return {{readReflectance(colors[0]), readReflectance(colors[1])}};
}

double readScale(const JsonValue& factor) {
    const double number = factor.positiveNumber();
    if (!isUv(number)) {
        factor.fail(kMustBeUv);
    }
    return number;
}

Texture readTexture(const JsonValue& value, const std::string& name, LoadContext& context) {
    const size_t type = choiceAt(value, "type", kTypes);
    const JsonObject object(value, type == kImage
                                       ? std::vector<std::string>{"type", "scale", "file", "wrap",
                                                                  "filter", "color_space"}
                                       : std::vector<std::string>{"type", "scale", "colors"});
    Texture texture;
    texture.name = name;
    if (const auto scale = object.optional("scale")) {
        const std::vector<JsonValue> factors = scale->array(2);
        texture.scale = {readScale(factors[0]), readScale(factors[1])};
    }
    if (type == kImage) {
        ImageTexture image = readImage(object, context);
        texture.isMissing = !image.image;
        if (texture.isMissing) {
            image.image = magentaImage();
        }
        texture.source = std::move(image);
    } else {
        texture.source = readChecker(object);
    }
    return texture;
}

} // namespace

void readTextures(const JsonValue& value, LoadContext& context) {
    if (!value.json().is_object()) {
        value.fail("must be an object of textures by name");
    }
    for (const auto& [name, unused] : value.json().items()) {
        context.addTexture(readTexture(value.child(name), name, context));
        context.textureNames.push_back(name);
    }
}

uint32_t findTexture(const JsonValue& reference, const LoadContext& context) {
    const auto& names = context.textureNames;
    const auto found = std::lower_bound(names.begin(), names.end(), reference.text());
    if (found == names.end() || *found != reference.text()) {
        reference.fail("there is no texture " + inQuotes(reference.text()) +
                       suggestion(reference.text(), names));
    }
    return static_cast<uint32_t>(found - names.begin());
}

} // namespace calotype
