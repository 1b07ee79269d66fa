#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "base/lowercase.h"

namespace calotype {

inline bool isBlank(char c) { return c == ' ' || c == '\t'; }

/// `text` without blanks at both ends.
inline std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

/// Reads the words of one line of text, separated by blanks. A word that starts with '#' opens a
/// comment, which ends the line.
class TextCursor {
public:
    explicit TextCursor(std::string_view line) : next_(line.data()), end_(next_ + line.size()) {
        skipBlanks();
    }

    /// True if nothing is left, or only a comment.
    bool atEnd() const { return next_ == end_ || *next_ == '#'; }

    /// The next word; empty at the end.
    std::string_view word() {
        const char* start = next_;
        while (next_ != end_ && !isBlank(*next_))
            ++next_;
        const std::string_view result(start, static_cast<size_t>(next_ - start));
        skipBlanks();
        return result;
    }

    /// The rest of the line, including a comment.
    std::string_view rest() const { return {next_, static_cast<size_t>(end_ - next_)}; }

private:
    void skipBlanks() {
        while (next_ != end_ && isBlank(*next_))
            ++next_;
    }

    const char* next_;
    const char* end_;
};

/// `word` without an exponent at its end: "e" or "E", a sign, and digits.
inline std::string_view withoutExponent(std::string_view word) {
    std::string_view rest = word;
    while (!rest.empty() && rest.back() >= '0' && rest.back() <= '9')
        rest.remove_suffix(1);
    const bool hasDigits = rest.size() < word.size();
    const bool hasSign = rest.ends_with('+') || rest.ends_with('-');
    if (!hasDigits || !hasSign)
        return word;
    rest.remove_suffix(1);
    return rest.ends_with('e') || rest.ends_with('E') ? rest.substr(0, rest.size() - 1) : word;
}

/// What Microsoft's older printf writes for infinity and NaN, whatever its precision: "1.#INF",
/// "-1.#IND00", "1.#QNAN", rounded "1.#QNB", "1.#J" and "1.$", and all these with an exponent, such
/// as "1.#INF00e+000". nullopt for anything else.
inline std::optional<double> parseMicrosoftNonFinite(std::string_view word) {
    const bool isNegative = word.starts_with('-');
    if (isNegative)
        word.remove_prefix(1);
    const bool isRounded = word.starts_with("1.$");
    if (!isRounded && !(word.starts_with("1.#") && word.size() > 3))
        return std::nullopt;
    std::string kind(withoutExponent(word.substr(3)));
    while (!kind.empty() && kind.back() == '0') // padding
        kind.pop_back();
    kind = lowercase(kind);
    constexpr std::string_view kNan[] = {"ind", "qnan", "snan", "qnb", "snb", "io",
                                         "qo",  "so",   "j",    "r",   "t"};
    if (kind == "inf")
        return isNegative ? -HUGE_VAL : HUGE_VAL;
    if (isRounded ? kind.empty() : std::ranges::find(kNan, kind) != std::end(kNan))
        return std::numeric_limits<double>::quiet_NaN();
    return std::nullopt;
}

/// A decimal number that is the whole word, or infinity or NaN in any form that printf writes;
/// infinite if it is too large for a double. nullopt for anything else.
inline std::optional<double> parseNumber(std::string_view word) {
    if (word.size() > 1 && word.front() == '+' && word[1] != '-')
        word.remove_prefix(1);
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument)
        return parseMicrosoftNonFinite(word);
    if (error == std::errc::result_out_of_range) {
        // from_chars does not say which: a negative exponent means nearly zero.
        return word.find("e-") != word.npos || word.find("E-") != word.npos ? 0.0 : HUGE_VAL;
    }
    return value;
}

} // namespace calotype
