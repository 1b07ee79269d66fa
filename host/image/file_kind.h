#pragma once

#include <string_view>

namespace calotype {

/// What a file is by its first bytes, such as "a DDS image" or "an empty file"; for messages about
/// files that are no image that can be read. Empty if it is not known.
std::string_view kindOfFile(std::string_view file);

} // namespace calotype
