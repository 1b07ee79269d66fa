#include "scene/read_textures.h"

#include <algorithm>

#include "scene/names.h"

namespace calotype {

void readTextures(const JsonValue& value, LoadContext&) {
    if (!value.json().is_object()) {
        value.fail("must be an object of textures by name");
    }
    if (!value.json().empty()) {
        failUnsupported(value, "an image or pattern in \"textures\"");
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
