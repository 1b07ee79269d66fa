#pragma once

#include <string_view>

namespace calotype {

/// The kind of a file by its first bytes, for messages: "a PLY mesh", "an empty file". Empty if it
/// is not known.
std::string_view fileKind(std::string_view bytes);

} // namespace calotype
