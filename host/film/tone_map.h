#pragma once

#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

namespace calotype {

/// How radiance after exposure is brought into [0, 1]. Each maps black to black, keeps greys grey
/// and never turns more light into a darker picture.
enum class ToneMap {
    None,     ///< clipped at 1
    Neutral,  ///< Khronos PBR Neutral: colours up to 0.76 keep their look, highlights roll off
    Reinhard, ///< c / (1 + max(c)): never clips, keeps every hue, flatter contrast
};

/// The names that toneMapFromName knows, for messages.
inline constexpr std::string_view kToneMapNames = "none, neutral or reinhard";

/// The tone map of that name; none if there is no such name.
std::optional<ToneMap> toneMapFromName(std::string_view name);

/// Maps finite, non-negative linear Rec. 709 RGB into [0, 1].
glm::vec3 applyToneMap(ToneMap toneMap, glm::vec3 color);

} // namespace calotype
