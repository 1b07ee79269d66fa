#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/progress.h"

namespace calotype {

/// Whether tinyobjloader reads the number in this word correctly, up to the last digits: it
/// multiplies mantissa and power separately; each may overflow, and the product may be NaN.
bool tinyobjReadsNumber(std::string_view word);

/// Whether an index fits the integers of tinyobjloader.
bool tinyobjReadsIndex(int64_t index);

/// The text of an OBJ in a form that tinyobjloader reads correctly: continued lines are joined,
/// faces have no comments and no empty last fields, faces of fewer than three corners are left out,
/// numbers of vertices are rewritten. A number that is not finite, and an index that does not fit,
/// become 0.
std::string textForTinyobj(std::string_view text, const OnProgress& onProgress = {});

} // namespace calotype
