#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace calotype {

/// `text`, which is UTF-8, as one line of at most `columns` columns of a terminal. Control
/// characters and broken UTF-8 become "?", because they could move the cursor. Characters that may
/// be two columns wide (of East Asia, emoji) count as two.
std::string fittedText(std::string_view text, size_t columns);

/// A part of a line. Where the line is too long, parts with the highest `rank` are left out first.
struct LinePart {
    std::string text;
    int rank = 0;
};

/// The parts in their order with two blanks between them, in at most `columns` columns. What is
/// left of a line that is still too long is cut off. Empty parts are left out.
std::string fittedLine(std::vector<LinePart> parts, size_t columns);

} // namespace calotype
