#include "scene/read_color.h"

#include <charconv>
#include <cmath>

#include "scene/names.h"

namespace calotype {
namespace {

/// IEC 61966-2-1, both sides in [0, 1].
double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

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
        failUnsupported(value, "the texture " + inQuotes(text));
    }
    value.fail(inQuotes(text) + " is not a colour \"#rrggbb\" of six hexadecimal digits");
}

glm::dvec3 readColor(const JsonValue& value, double highest, const std::string& range) {
    if (value.json().is_string()) {
        return readHexColor(value);
    }
    const auto component = [&](const JsonValue& v) {
        const double x = v.number();
        if (!(x >= 0.0 && x <= highest)) {
            v.fail("must be " + range + ", not " + v.json().dump());
        }
        return x;
    };
    if (value.json().is_number()) {
        return glm::dvec3(component(value));
    }
    if (!value.json().is_array() || value.json().size() != 3) {
        value.fail("must be a colour: [r, g, b], one number, or \"#rrggbb\"");
    }
    const std::vector<JsonValue> rgb = value.array();
    return {component(rgb[0]), component(rgb[1]), component(rgb[2])};
}

} // namespace

glm::dvec3 readReflectance(const JsonValue& value) { return readColor(value, 1.0, "in [0, 1]"); }

glm::dvec3 readRadiance(const JsonValue& value) {
    return readColor(value, HUGE_VAL, "0 or greater");
}

} // namespace calotype
