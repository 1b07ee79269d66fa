#include "base/terminal_text.h"

#include <algorithm>
#include <cstdint>

namespace calotype {
namespace {

/// From Hangul Jamo on, Unicode has characters of two columns.
constexpr uint32_t kFirstWide = 0x1100;

struct Character {
    uint32_t code = 0; ///< 0: broken UTF-8
    size_t bytes = 1;
};

/// The first character of a text that is not empty.
Character decode(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const size_t bytes = first < 0x80   ? 1
                         : first < 0xC2 ? 0
                         : first < 0xE0 ? 2
                         : first < 0xF0 ? 3
                                        : 4;
    if (bytes == 0 || first > 0xF4 || bytes > text.size())
        return {};
    uint32_t code = bytes == 1 ? first : first & (0x7Fu >> bytes);
    for (size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0) != 0x80)
            return {};
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    return {code, bytes};
}

/// Also of the second block of control characters, and of what changes the direction of writing.
bool isControl(uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

/// The columns of the whole text.
size_t columnsOf(std::string_view text) {
    size_t columns = 0;
    for (size_t at = 0; at < text.size();) {
        const Character character = decode(text.substr(at));
        columns += character.code >= kFirstWide && !isControl(character.code) ? 2 : 1;
        at += character.bytes;
    }
    return columns;
}

std::string joined(const std::vector<LinePart>& parts) {
    std::string line;
    for (const LinePart& part : parts)
        line += (line.empty() ? "" : "  ") + part.text;
    return line;
}

} // namespace

std::string fittedText(std::string_view text, size_t columns) {
    std::string fitted;
    size_t used = 0;
    for (size_t at = 0; at < text.size();) {
        const Character character = decode(text.substr(at));
        const std::string_view shown =
            isControl(character.code) ? "?" : text.substr(at, character.bytes);
        used += columnsOf(shown);
        if (used > columns)
            break;
        fitted += shown;
        at += character.bytes;
    }
    return fitted;
}

std::string fittedLine(std::vector<LinePart> parts, size_t columns) {
    std::erase_if(parts, [](const LinePart& part) { return part.text.empty(); });
    while (parts.size() > 1 && columnsOf(joined(parts)) > columns)
        parts.erase(std::ranges::max_element(parts, {}, &LinePart::rank));
    return fittedText(joined(parts), columns);
}

} // namespace calotype
