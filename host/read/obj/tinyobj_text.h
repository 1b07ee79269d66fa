#pragma once

#include <string>
#include <string_view>

namespace calotype {

/// Whether tinyobjloader reads the number in this word correctly, up to the last digits: it
/// multiplies mantissa and power separately; each may overflow, and the product may be NaN.
bool tinyobjReadsNumber(std::string_view word);

/// The text of an OBJ in a form that tinyobjloader reads correctly: continued lines are joined,
/// faces have no comments and no empty last fields, numbers of vertices are rewritten. A number
/// that is not finite becomes 0.
std::string textForTinyobj(std::string_view text);

} // namespace calotype
