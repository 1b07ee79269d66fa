#pragma once

#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

namespace calotype {

/// How radiance after exposure is mapped to [0, 1]. Each maps black to black and grey to grey, and
/// more light never gives a darker pixel.
enum class ToneMap {
    None,     ///< clipped at 1
    Neutral,  ///< Khronos PBR Neutral: colours up to 0.76 keep their look, highlights roll off
    Reinhard, ///< c / (1 + max(c)): never clips, keeps every hue, flatter contrast
    Agx,      ///< AgX, base look: 16.5 stops, saturated highlights turn white
};

/// The names that toneMapFromName accepts, for messages.
inline constexpr std::string_view kToneMapNames = "none, neutral, reinhard or agx";

/// The tone map of that name; none if there is no such name.
std::optional<ToneMap> toneMapFromName(std::string_view name);

/// Maps finite, non-negative linear Rec. 709 RGB into [0, 1].
glm::vec3 applyToneMap(ToneMap toneMap, glm::vec3 color);

} // namespace calotype
