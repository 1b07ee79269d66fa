#pragma once

#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

#include "image/image.h"

namespace calotype {

/// How radiance after exposure is mapped to [0, 1]. Each maps black to black and grey to grey, and
/// more light never gives a darker pixel.
enum class ToneMap {
    None,     ///< clipped at 1
    Neutral,  ///< Khronos PBR Neutral: colours up to 0.76 keep their look, highlights roll off
    Reinhard, ///< c / (1 + max(c)): never clips, keeps every hue, flatter contrast
};

/// The names that toneMapFromName accepts, for messages.
inline constexpr std::string_view kToneMapNames = "none, neutral or reinhard";

/// The tone map of that name; none if there is no such name.
std::optional<ToneMap> toneMapFromName(std::string_view name);

/// Maps finite, non-negative linear Rec. 709 RGB into [0, 1].
glm::vec3 applyToneMap(ToneMap toneMap, glm::vec3 color);

/// Converts radiance to display values.
struct DisplayTransform {
    float exposureStops = 0.0f; ///< radiance is multiplied by 2^stops
    ToneMap toneMap = ToneMap::None;
};

/// Exposes, tone maps, encodes as sRGB and rounds to the nearest of 256 levels. Channels that are
/// negative or not finite become 0 first.
Rgb8Image toDisplay(const Image& image, const DisplayTransform& transform);

} // namespace calotype
