#pragma once

#include <cstdint>

namespace calotype {

/// What removes the noise of a picture.
enum class DenoiserKind : uint8_t {
    Off,
    Oidn,        ///< Open Image Denoise 2
    Statistical, ///< our own: docs/models.md, "The statistical denoiser"
};

/// The name in options.
constexpr const char* nameOf(DenoiserKind kind) {
    switch (kind) {
    case DenoiserKind::Off:
        return "off";
    case DenoiserKind::Oidn:
        return "oidn";
    case DenoiserKind::Statistical:
        break;
    }
    return "statistical";
}

} // namespace calotype
