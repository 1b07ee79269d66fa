#pragma once

#include <span>
#include <string>
#include <string_view>

namespace calotype {

/// `text` for a message: quotes and control characters escaped as in JSON, long texts shortened.
std::string printable(std::string_view text);

/// `printable(text)` in double quotes.
std::string inQuotes(std::string_view text);

/// A number for a message, with two digits.
std::string twoDigits(double number);

/// The text with U+FFFD in place of bytes that are no UTF-8.
std::string asUtf8(const std::string& text);

/// Names in quotes, separated by commas; the first twenty if there are many.
std::string listInQuotes(std::span<const std::string> names);

/// Paths or names as they are, separated by commas: "a.exr, a.png".
std::string listed(std::span<const std::string> names);

/// The text as one word of a shell, in single quotes where it needs them.
std::string shellWord(const std::string& text);

/// The end of a sentence about an unknown `name`: `did you mean "radius"?`, or the list of known
/// names if none is similar. Empty if there are no known names.
std::string suggestion(std::string_view name, std::span<const std::string> known);

/// The nearest of `known` by edit distance (insert, delete, replace, swap neighbours), or empty if
/// more than half of the longer name would have to change.
std::string nearestName(std::string_view name, std::span<const std::string> known);

} // namespace calotype
