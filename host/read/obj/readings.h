#pragma once

#include <string_view>
#include <vector>

namespace calotype {

/// `text` without its comment, which is a '#' at the start or after a blank, and what follows it;
/// and without blanks at both ends.
std::string_view withoutComment(std::string_view text);

/// `text` without quotes around it.
std::string_view withoutQuotes(std::string_view text);

/// The names that the end of a line may mean: names may hold blanks and '#', and no rule of the
/// format says where a comment starts. First the whole, then what is before the last '#' after a
/// blank, then withoutComment(text); each is followed by itself without quotes. They differ from
/// each other. The last may be empty.
std::vector<std::string_view> readingsOf(std::string_view text);

} // namespace calotype
