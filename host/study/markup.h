#pragma once

#include <string>
#include <string_view>

#include "image/image.h"

namespace calotype {

/// Text with the characters escaped that XML and HTML reserve.
std::string escaped(std::string_view text);

/// "data:image/png;base64,...": a picture within a page (RFC 2397, RFC 4648).
std::string dataUri(const Rgb8Image& image);

/// A number for coordinates: two decimals.
std::string coordinate(double value);

} // namespace calotype
