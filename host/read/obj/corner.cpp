#include "read/obj/corner.h"

#include <charconv>
#include <limits>

namespace calotype {

std::optional<ObjCorner> parseObjCorner(std::string_view word) {
    ObjCorner corner;
    const char* next = word.data();
    const char* const end = next + word.size();
    for (size_t field = 0; field < kObjDataCount; ++field) {
        int64_t index = 0;
        const auto [stop, error] = std::from_chars(next, end, index);
        if (error == std::errc::result_out_of_range) {
            using Limits = std::numeric_limits<int64_t>;
            index = *next == '-' ? Limits::min() : Limits::max();
        }
        if (stop != next)
            corner[field] = index;
        else if (field == 0)
            return std::nullopt;
        next = stop;
        if (next == end)
            return corner;
        if (*next != '/')
            return std::nullopt;
        ++next;
    }
    return std::nullopt;
}

bool parseObjFace(TextCursor cursor, std::vector<ObjCorner>& corners) {
    corners.clear();
    while (!cursor.atEnd()) {
        const std::optional<ObjCorner> corner = parseObjCorner(cursor.word());
        if (!corner)
            return false;
        corners.push_back(*corner);
    }
    return true;
}

} // namespace calotype
