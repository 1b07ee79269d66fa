#include "read/obj/mtl_texture.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "base/text_cursor.h"
#include "read/obj/readings.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

/// Steeper slopes are vertical walls already; their squares stay within double.
constexpr Range kBumpMultiplier = closedRange(-1e6, 1e6);

std::optional<TexelChannel> channelOf(std::string_view word) {
    if (word == "r")
        return TexelChannel::Red;
    if (word == "g")
        return TexelChannel::Green;
    if (word == "b")
        return TexelChannel::Blue;
    if (word == "m")
        return TexelChannel::Alpha;
    if (word == "l")
        return TexelChannel::Luminance;
    return std::nullopt;
}

/// Reads options from the start of a text.
class OptionReader {
public:
    OptionReader(MtlTexture& texture, std::string_view text, bool nameFollows)
        : texture_(texture), cursor_(text), nameFollows_(nameFollows) {}

    /// Reads all options and returns the rest of the text.
    std::string_view read() {
        while (true) {
            TextCursor next = cursor_;
            const std::string_view option = next.word();
            if (!option.starts_with('-'))
                return cursor_.rest();
            const TextCursor before = cursor_;
            cursor_ = next;
            if (!readOption(option))
                return before.rest(); // the name begins with a hyphen
        }
    }

    /// What has not been read.
    std::string_view rest() const { return cursor_.rest(); }

private:
    [[noreturn]] void fail(std::string_view option, const std::string& message) const {
        throw SceneError(texture_.place, "the option " + inQuotes(option) + " " + message);
    }

    bool readOption(std::string_view option) {
        if (option == "-s") {
            texture_.scale = vector(option, texture_.scale);
        } else if (option == "-o") {
            texture_.offset = vector(option, texture_.offset);
        } else if (option == "-t") {
            ignoreUnless(vector(option, glm::dvec2(0.0)) == glm::dvec2(0.0), option);
        } else if (option == "-bm") {
            texture_.bumpMultiplier = number(option);
        } else if (option == "-mm") {
            const double base = number(option);
            const double gain = number(option);
            ignoreUnless(base == 0.0 && gain == 1.0, option);
        } else if (option == "-boost") {
            ignoreUnless(number(option) == 0.0, option);
        } else if (option == "-texres") {
            cursor_.word(); // the resolution of a copy, which is not needed
        } else if (option == "-clamp") {
            texture_.clamps = isOn(option);
        } else if (option == "-cc") {
            ignoreUnless(!isOn(option), option);
        } else if (option == "-blendu" || option == "-blendv") {
            ignoreUnless(isOn(option), option);
        } else if (option == "-type") {
            cursor_.word();
            ignoreUnless(false, option);
        } else if (option == "-imfchan") {
            texture_.channel = channelOf(cursor_.word());
            ignoreUnless(texture_.channel.has_value(), option);
        } else if (option == "-colorspace") {
            texture_.isLinear = cursor_.word() == "linear";
        } else {
            return false;
        }
        return true;
    }

    void ignoreUnless(bool harmless, std::string_view option) {
        if (!harmless && std::ranges::find(texture_.ignored, option) == texture_.ignored.end())
            texture_.ignored.emplace_back(option);
    }

    bool isOn(std::string_view option) {
        const std::string_view word = cursor_.word();
        if (word != "on" && word != "off")
            fail(option, "needs \"on\" or \"off\", not " + inQuotes(word));
        return word == "on";
    }

    double number(std::string_view option) {
        const std::string_view word = cursor_.word();
        const std::optional<double> value = parseNumber(word);
        if (!value || !std::isfinite(*value))
            fail(option, "needs a number, not " + inQuotes(word));
        return *value;
    }

    /// One to three numbers; the third is for 3D textures and ignored. The last word is the file's
    /// name, even if it is a number.
    glm::dvec2 vector(std::string_view option, glm::dvec2 value) {
        value.x = number(option);
        for (int i = 1; i < 3; ++i) {
            TextCursor next = cursor_;
            const bool isNumber = parseNumber(next.word()).has_value();
            if (!isNumber || (nameFollows_ && next.atEnd()))
                break;
            const double component = number(option);
            value.y = i == 1 ? component : value.y;
        }
        return value;
    }

    MtlTexture& texture_;
    TextCursor cursor_;
    bool nameFollows_;
};

/// Removes options from the end of a name if the text after some blank consists of options. Each
/// attempt begins where the one before stopped, so that the time is in proportion to the length.
std::string_view readTrailingOptions(MtlTexture& texture, std::string_view name) {
    for (size_t at = name.find(" -"); at != std::string_view::npos;) {
        MtlTexture withOptions = texture;
        OptionReader reader(withOptions, name.substr(at), false);
        try {
            if (reader.read().empty()) {
                texture = withOptions;
                return name.substr(0, at);
            }
        } catch (const SceneError&) { // it is part of the name
        }
        const size_t blank = name.size() - reader.rest().size() - 1;
        at = name.find(" -", std::max(at + 1, blank));
    }
    return name;
}

void limit(double& number, const Range& range, MtlTexture& texture) {
    texture.isLimited = texture.isLimited || !range.contains(number);
    number = std::clamp(number, range.low, range.high);
}

} // namespace

std::optional<MtlTexture> parseMtlTexture(std::string_view text, const std::string& place) {
    MtlTexture texture;
    texture.place = place;
    std::string_view name = OptionReader(texture, trimmed(text), true).read();
    name = withoutQuotes(trimmed(readTrailingOptions(texture, name)));
    if (name.empty())
        return std::nullopt;
    for (glm::dvec2* vector : {&texture.scale, &texture.offset}) {
        limit(vector->x, ranges::kTextureCoordinate, texture);
        limit(vector->y, ranges::kTextureCoordinate, texture);
    }
    limit(texture.bumpMultiplier, kBumpMultiplier, texture);
    texture.file = name;
    return texture;
}

} // namespace calotype
