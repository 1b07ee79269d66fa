#include "read/obj/mtl_texture.h"

#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "base/text_cursor.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

/// Longer names are not searched for options: the time grows with the square of the length.
constexpr size_t kLongestName = 4096;

/// Without a comment, which starts with a '#' after a blank.
std::string_view withoutComment(std::string_view text) {
    for (size_t i = 0; i < text.size(); ++i) {
        const bool startsWord = i == 0 || isBlank(text[i - 1]);
        const bool endsWord = i + 1 == text.size() || isBlank(text[i + 1]);
        if (text[i] == '#' && startsWord && endsWord)
            return text.substr(0, i);
    }
    return text;
}

std::string_view withoutQuotes(std::string_view text) {
    const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

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
        if (!harmless)
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

/// Removes options from the end of a name if the text after some blank consists of options.
std::string_view readTrailingOptions(MtlTexture& texture, std::string_view name) {
    if (name.size() > kLongestName)
        return name;
    for (size_t at = name.find(" -"); at != std::string_view::npos; at = name.find(" -", at + 1)) {
        MtlTexture withOptions = texture;
        try {
            if (OptionReader(withOptions, name.substr(at), false).read().empty()) {
                texture = withOptions;
                return name.substr(0, at);
            }
        } catch (const SceneError&) {
            continue; // it is part of the name
        }
    }
    return name;
}

void checkRange(std::string_view option, const glm::dvec2& value, const std::string& place) {
    if (!ranges::kTextureCoordinate.contains(value.x) ||
        !ranges::kTextureCoordinate.contains(value.y)) {
        throw SceneError(place, "the numbers of the option " + inQuotes(option) + " must be " +
                                    toText(ranges::kTextureCoordinate));
    }
}

} // namespace

std::optional<MtlTexture> parseMtlTexture(std::string_view text, const std::string& place) {
    MtlTexture texture;
    texture.place = place;
    std::string_view name = OptionReader(texture, trimmed(withoutComment(text)), true).read();
    name = withoutQuotes(trimmed(readTrailingOptions(texture, name)));
    if (name.empty())
        return std::nullopt;
    checkRange("-s", texture.scale, place);
    checkRange("-o", texture.offset, place);
    texture.file = name;
    return texture;
}

} // namespace calotype
