#pragma once

#include <string>
#include <string_view>

namespace calotype {

/// Whether tinyobjloader reads the number in this word as we do, but for the last digits: it
/// multiplies mantissa and power separately, each of which may overflow, or cancel to NaN.
bool tinyobjReadsNumber(std::string_view word);

/// The text of an OBJ as tinyobjloader reads it rightly: continued lines joined, faces without
/// comments and empty last fields, numbers of vertices written anew. What is no finite number
/// becomes 0.
std::string textForTinyobj(std::string_view text);

} // namespace calotype
