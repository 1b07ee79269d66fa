#include "read/obj/readings.h"

#include <algorithm>

#include "base/text_cursor.h"

namespace calotype {
namespace {

bool startsComment(std::string_view text, size_t at) {
    return text[at] == '#' && (at == 0 || isBlank(text[at - 1]));
}

std::string_view withoutLastComment(std::string_view text) {
    for (size_t i = text.size(); i-- > 0;)
        if (startsComment(text, i))
            return trimmed(text.substr(0, i));
    return trimmed(text);
}

} // namespace

std::string_view withoutComment(std::string_view text) {
    for (size_t i = 0; i < text.size(); ++i)
        if (startsComment(text, i))
            return trimmed(text.substr(0, i));
    return trimmed(text);
}

std::string_view withoutQuotes(std::string_view text) {
    const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

std::vector<std::string_view> readingsOf(std::string_view text) {
    std::vector<std::string_view> readings;
    for (const std::string_view part :
         {trimmed(text), withoutLastComment(text), withoutComment(text)}) {
        for (const std::string_view reading : {part, trimmed(withoutQuotes(part))})
            if (std::ranges::find(readings, reading) == readings.end())
                readings.push_back(reading);
    }
    return readings;
}

} // namespace calotype
