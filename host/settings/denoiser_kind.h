#pragma once

#include <cstdint>

namespace calotype {

/// What removes the noise of a picture.
enum class DenoiserKind : uint8_t {
    Off,
    Oidn, ///< Open Image Denoise 2
};

/// The name in options.
constexpr const char* nameOf(DenoiserKind kind) {
    return kind == DenoiserKind::Oidn ? "oidn" : "off";
}

} // namespace calotype
