#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "base/lowercase.h"
#include "base/text_cursor.h"

namespace calotype {

/// Removes the byte order mark that some editors put before UTF-8.
inline std::string_view withoutByteOrderMark(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

/// The first word of a line of an OBJ, in lower case: some exporters write capitals.
inline std::string objKeyword(TextCursor& cursor) { return lowercase(cursor.word()); }

/// The number of lines, or fewer if some end in CR alone; for the progress.
inline size_t lineCount(std::string_view text) {
    return static_cast<size_t>(std::ranges::count(text, '\n')) + 1;
}

/// Calls `visit(number, line)` for each line of an OBJ or MTL text, numbered from 1, without
/// leading blanks and line end (LF, CRLF or CR). A line that ends in a backslash, unless it is a
/// comment, continues on the next; both are visited as one line, with the number of the first.
template <typename Visit>
void forEachObjLine(std::string_view text, Visit&& visit) {
    std::string joined;
    bool continues = false;
    size_t number = 0;
    size_t firstNumber = 0;
    size_t start = 0;
    size_t newline = 0; // the first LF at `start` or later
    while (start < text.size()) {
        if (newline <= start)
            newline = std::min(text.find('\n', start), text.size());
        std::string_view line = text.substr(start, newline - start);
        const size_t carriageReturn = line.find('\r');
        if (carriageReturn != std::string_view::npos)
            line = line.substr(0, carriageReturn);
        const bool crThenLf = start + line.size() + 1 == newline;
        start += line.size() + (carriageReturn != std::string_view::npos && crThenLf ? 2 : 1);
        ++number;
        while (!line.empty() && isBlank(line.front()))
            line.remove_prefix(1);
        if (!continues)
            firstNumber = number;
        const bool comment = !continues && !line.empty() && line.front() == '#';
        if (!comment && !line.empty() && line.back() == '\\') {
            line.remove_suffix(1);
            joined.append(line).append(" ");
            continues = true;
            continue;
        }
        if (continues) {
            joined.append(line);
            visit(firstNumber, std::string_view(joined));
            joined.clear();
            continues = false;
        } else {
            visit(number, line);
        }
    }
    if (continues)
        visit(firstNumber, std::string_view(joined));
}

} // namespace calotype
