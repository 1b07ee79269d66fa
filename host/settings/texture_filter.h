#pragma once

#include <cstdint>

namespace calotype {

/// How a texture is read between the centres of its texels.
enum class TextureFilter : uint8_t { Bilinear, Nearest };

/// The name in options.
constexpr const char* nameOf(TextureFilter filter) {
    return filter == TextureFilter::Nearest ? "nearest" : "bilinear";
}

} // namespace calotype
