#include "read/obj/tinyobj_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/text_cursor.h"
#include "read/obj/corner.h"
#include "read/obj/lines.h"

namespace calotype {
namespace {

/// Empty if there are fewer than three corners, or one that cannot be read.
std::string tidyFace(const TextCursor& cursor) {
    std::vector<ObjCorner> corners;
    if (!parseObjFace(cursor, corners) || corners.size() < 3)
        return "";
    std::string result = "f";
    for (const ObjCorner& corner : corners) {
        result.push_back(' ');
        size_t slashes = 0;
        for (size_t kind = 0; kind < kObjDataCount; ++kind) {
            if (!corner[kind])
                continue;
            for (; slashes < kind; ++slashes)
                result.push_back('/');
            result.append(std::to_string(tinyobjReadsIndex(*corner[kind]) ? *corner[kind] : 0));
        }
    }
    return result;
}

std::string tidyVertex(std::string_view keyword, TextCursor cursor) {
    std::string result(keyword);
    if (cursor.atEnd())
        return result + " 0"; // without a number it is not counted
    while (!cursor.atEnd()) {
        const double value = parseNumber(cursor.word()).value_or(0.0);
        std::array<char, 32> digits{}; // the shortest form of a double has at most 24
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                       std::isfinite(value) ? value : 0.0)
                             .ptr;
        result.append(" ").append(digits.data(), end);
    }
    return result;
}

} // namespace

/// Up to 200 characters and two exponent digits, no factor exceeds the range of doubles.
bool tinyobjReadsNumber(std::string_view word) {
    constexpr size_t kLongest = 200;
    constexpr size_t kLongestExponent = 3; // its sign and two digits
    const size_t exponent = word.find_first_of("eE");
    return word.size() < kLongest &&
           (exponent == word.npos || word.size() - exponent - 1 <= kLongestExponent);
}

bool tinyobjReadsIndex(int64_t index) {
    return index >= std::numeric_limits<int>::min() && index <= std::numeric_limits<int>::max();
}

std::string textForTinyobj(std::string_view text, const OnProgress& onProgress) {
    std::string result;
    result.reserve(text.size() + 1);
    const size_t lines = lineCount(text);
    forEachObjLine(text, [&](size_t number, std::string_view line) {
        reportStep(onProgress, number, lines);
        TextCursor cursor(line);
        const std::string keyword = objKeyword(cursor);
        if (keyword == "f")
            result.append(tidyFace(cursor));
        else if (keyword == "v" || keyword == "vt" || keyword == "vn")
            result.append(tidyVertex(keyword, cursor));
        else
            result.append(line);
        result.push_back('\n');
    });
    return result;
}

} // namespace calotype
