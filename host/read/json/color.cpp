#include "read/json/color.h"

#include <charconv>
#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/names.h"
#include "image/srgb.h"

namespace calotype {
namespace {

glm::dvec3 readHexColor(const JsonValue& value) {
    const std::string& text = value.text();
    uint32_t rgb = 0;
    const char* digits = text.data() + 1;
    const char* end = text.data() + text.size();
    if (text.size() == 7 && text[0] == '#' && std::from_chars(digits, end, rgb, 16).ptr == end) {
        return {linearFromSrgb((rgb >> 16) / 255.0), linearFromSrgb((rgb >> 8 & 255) / 255.0),
                linearFromSrgb((rgb & 255) / 255.0)};
    }
    if (!text.starts_with("#")) {
        value.fail("must be a colour: [r, g, b], one number, or \"#rrggbb\"; " + inQuotes(text) +
                   " is none, and textures cannot stand here");
    }
    value.fail(inQuotes(text) + " is not a colour \"#rrggbb\" of six hexadecimal digits");
}

} // namespace

glm::dvec3 readColor(const JsonValue& value, const Range& channel) {
    if (value.json().is_string())
        return readHexColor(value);
    if (value.json().is_number())
        return glm::dvec3(value.numberIn(channel));
    if (!value.json().is_array() || value.json().size() != 3)
        value.fail("must be a colour: [r, g, b], one number, or \"#rrggbb\"");
    const std::vector<JsonValue> rgb = value.array();
    return {rgb[0].numberIn(channel), rgb[1].numberIn(channel), rgb[2].numberIn(channel)};
}

bool canBeTextureName(const std::string& text) { return !text.empty() && text.front() != '#'; }

} // namespace calotype
