#include "base/names.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <sstream>
#include <vector>

#include <nlohmann/json.hpp>

namespace calotype {
namespace {

constexpr size_t kLongest = 60;
constexpr size_t kLongestList = 20;
/// Longer names are not misspellings, and the distance costs the product of the lengths.
constexpr size_t kLongestMisspelling = 64;

bool continuesUtf8(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

bool isPlain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

/// Optimal string alignment: Levenshtein's distance with swaps of adjacent characters.
size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<size_t> twoAgo(b.size() + 1);
    std::vector<size_t> previous(b.size() + 1);
    std::vector<size_t> current(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
        previous[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], twoAgo[j - 2] + 1);
        }
        std::swap(twoAgo, previous);
        std::swap(previous, current);
    }
    return previous[b.size()];
}

} // namespace

std::string printable(std::string_view text) {
    using nlohmann::json;
    if (text.size() <= kLongest && std::ranges::all_of(text, isPlain))
        return std::string(text); // nearly always, and much faster
    const bool isLong = text.size() > kLongest;
    if (isLong) {
        size_t end = kLongest;
        while (end > 0 && continuesUtf8(text[end]))
            --end;
        text = text.substr(0, end);
    }
    const std::string quoted = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
    return quoted.substr(1, quoted.size() - 2) + (isLong ? "..." : "");
}

std::string asUtf8(const std::string& text) {
    using nlohmann::json;
    return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace))
        .get<std::string>();
}

std::string inQuotes(std::string_view text) { return '"' + printable(text) + '"'; }

std::string twoDigits(double number) {
    std::ostringstream text;
    text.precision(2);
    text << number;
    return text.str();
}

std::string listInQuotes(std::span<const std::string> names) {
    std::string list;
    for (size_t i = 0; i < std::min(names.size(), kLongestList); ++i)
        list += (i > 0 ? ", " : "") + inQuotes(names[i]);
    if (names.size() > kLongestList)
        list += " and " + std::to_string(names.size() - kLongestList) + " more";
    return list;
}

std::string nearestName(std::string_view name, std::span<const std::string> known) {
    std::string nearest;
    size_t best = kLongestMisspelling;
    for (const std::string& candidate : known) {
        const size_t longer = std::max(name.size(), candidate.size());
        if (longer > kLongestMisspelling)
            continue;
        const size_t distance = editDistance(name, candidate);
        if (distance < best && 2 * distance <= longer) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string listed(std::span<const std::string> names) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::string shellWord(const std::string& text) {
    const auto isBare = [](unsigned char c) {
        return std::isalnum(c) || std::strchr("_-./=,:", c) != nullptr;
    };
    if (!text.empty() && std::ranges::all_of(text, isBare))
        return text;
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::string suggestion(std::string_view name, std::span<const std::string> known) {
    const std::string nearest = nearestName(name, known);
    if (!nearest.empty())
        return "; did you mean " + inQuotes(nearest) + "?";
    return known.empty() ? std::string() : "; known here: " + listInQuotes(known);
}

} // namespace calotype
