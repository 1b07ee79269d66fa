#pragma once

#include <limits>

#include "settings/light_choice.h"

namespace calotype {

/// How light is looked for along a path. All but the clamp leave the expected picture as it is.
struct TransportSettings {
    /// Whether light found by both strategies is shared between them by multiple importance
    /// sampling; else light that sampling lights could have found counts only where that found it.
    bool usesMis = true;
    /// Whether paths that carry little light end early, by chance.
    bool usesRoulette = true;
    /// The most that one contribution of light scattered twice or more may bring in any channel,
    /// W/(m^2 sr); infinite for no limit. It darkens the picture.
    float indirectClamp = std::numeric_limits<float>::infinity();

    LightChoice lightChoice = LightChoice::Power;

    bool clampsIndirect() const { return indirectClamp < std::numeric_limits<float>::infinity(); }
};

} // namespace calotype
