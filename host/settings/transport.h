#pragma once

#include <limits>

#include "settings/light_choice.h"

namespace calotype {

/// Settings of light transport. Except the clamp, they do not change the expected picture.
struct TransportSettings {
    /// Whether multiple importance sampling weights light that both strategies can find; if not,
    /// such light counts only if light sampling found it.
    bool usesMis = true;
    /// Whether paths that carry little light end early, at random.
    bool usesRoulette = true;
    /// Limit of one contribution of light scattered twice or more, for each channel, W/(m^2 sr);
    /// infinite for no limit. It darkens the picture.
    float indirectClamp = std::numeric_limits<float>::infinity();

    LightChoice lightChoice = LightChoice::Power;

    bool clampsIndirect() const { return indirectClamp < std::numeric_limits<float>::infinity(); }
};

} // namespace calotype
